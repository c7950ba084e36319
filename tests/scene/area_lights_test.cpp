// Which lights an emitting shape becomes: how many, how bright, and to which side they shine.
#include "scene/area_lights.h"

#include "light/emitting_surface.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr float kRadiance = 3;

ShapeDescription emitting(Shape shape, const Matrix& to_world = {}, bool flip = false) {
    return {{std::move(shape), to_world, flip},
            0,
            AreaEmission{Spectrum::constant(kRadiance), false, 0},
            {}};
}

/// The unit square of the plane z = 0 in two triangles, wound counter-clockwise around +z.
TriangleMesh square() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Matrix scaled(const Vec3d& by, const Vec3d& move) {
    Matrix matrix;
    matrix.translate(move);
    matrix.scale(by);
    return matrix;
}

double radiance_of(const AreaLight& light) {
    return static_cast<double>(light.curve(550));
}

double flux_of(const AreaLight& light) {
    return light.power({}) * radiance_of(light);
}

TEST(AreaLights, each_triangle_is_a_light_where_it_stands) {
    ShapeDescription shape = emitting(square(), scaled({2, 3, 1}, {10, 20, 30}));
    shape.emission->two_sided = true;
    const std::vector<AreaLight> lights = area_lights_of(shape, 7);
    ASSERT_EQ(lights.size(), 2U);
    for (std::uint32_t i = 0; i < 2; ++i) {
        EXPECT_EQ(lights[i].shape, 7U);
        EXPECT_EQ(lights[i].primitive, i);
        EXPECT_TRUE(lights[i].two_sided);
        EXPECT_EQ(radiance_of(lights[i]), kRadiance);
        EXPECT_NEAR(lights[i].area(), 3, 1e-12);
    }
    const auto& second = std::get<EmittingTriangle>(lights[1].surface);
    EXPECT_EQ(second.p0, Vec3d(10, 20, 30));
    EXPECT_EQ(second.edge1, Vec3d(2, 3, 0));
    EXPECT_EQ(second.edge2, Vec3d(0, 3, 0));
    EXPECT_EQ(second.normal, Vec3d(0, 0, 1));
}

/// All that turns the side of a triangle: winding, ReverseOrientation, a matrix that mirrors,
/// vertex normals for and against the winding. The light's side must be that of the hit, or the
/// two halves of direct light would disagree.
TEST(AreaLights, a_triangle_shines_to_the_side_of_its_hits) {
    int up = 0;
    for (int bits = 0; bits < 24; ++bits) {
        const bool flip = (bits & 1) != 0;
        const bool mirror = (bits & 2) != 0;
        const bool turned = (bits & 4) != 0;
        const int normals = bits / 8;  // none, along +z, along -z of the object
        SCOPED_TRACE(bits);
        TriangleMesh mesh = square();
        if (turned) mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
        if (normals > 0) mesh.normals.assign(4, Vec3(0.3F, 0, normals == 1 ? 1.0F : -1.0F));
        ShapeDescription shape =
            emitting(mesh, scaled({2, mirror ? -3.0 : 3.0, 1}, {0, mirror ? 3.0 : 0.0, 5}), flip);
        const auto lights = area_lights_of(shape, 0);
        SceneDescription description;
        description.materials = {DiffuseMaterial{}};
        description.shapes = {shape};
        const Scene scene(std::move(description));
        const auto hit = scene.geometry().intersect({{0.5F, 1, 9}, {0, 0, -1}, kInfinity});
        ASSERT_TRUE(hit);
        const auto& light = lights[hit->primitive];
        const Vec3d side = std::get<EmittingTriangle>(light.surface).normal;
        EXPECT_NEAR((side - Vec3d(hit->normal)).length(), 0, 1e-6);
        // pbrt-v4: the winding counts in the object's frame; vertex normals count more.
        const bool up_by_winding = !turned;
        const bool up_in_object = normals == 0 ? up_by_winding : normals == 1;
        EXPECT_EQ(side.z > 0, up_in_object != flip);
        up += side.z > 0 ? 1 : 0;
        EXPECT_EQ(light.emits(hit->normal, {0, 0, 1}), side.z > 0);
    }
    EXPECT_EQ(up, 12);
}

/// The same for patches and cylinders, and their places and sizes with it.
TEST(AreaLights, patches_and_cylinders_shine_to_the_side_of_their_hits) {
    for (int bits = 0; bits < 24; ++bits) {
        const bool flip = (bits & 1) != 0;
        const bool mirror = (bits & 2) != 0;
        const int kind = bits / 4;  // patch; with normals along +z, along -z; cylinder
        SCOPED_TRACE(bits);
        Shape shape = Cylinder{0.5, -1, 1};
        if (kind < 3) {
            BilinearMesh mesh;
            mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5F}};
            mesh.patches = {{0, 1, 2, 3}, {1, 0, 3, 2}};
            if (kind > 0) mesh.normals.assign(4, Vec3(0.3F, 0, kind == 1 ? 1.0F : -1.0F));
            shape = mesh;
        }
        const ShapeDescription emitter =
            emitting(shape, scaled({2, mirror ? -3.0 : 3.0, 1}, {0, mirror ? 3.0 : 0.0, 5}), flip);
        const auto lights = area_lights_of(emitter, 0);
        ASSERT_EQ(lights.size(), kind < 3 ? 2U : 1U);
        SceneDescription description;
        description.materials = {DiffuseMaterial{}};
        description.shapes = {emitter};
        const Scene scene(std::move(description));
        for (const AreaLight& light : lights)
            for (const double u : {0.1, 0.4, 0.9}) {
                const Emission e = light.sample_emission({u, 1 - u * u, 0.4, 0.2}, {});
                const Vec3d from = e.origin + Vec3d(e.normal);
                const Ray ray{Vec3(from), -e.normal, 1.5F};
                const auto hit = scene.geometry().intersect(ray);
                ASSERT_TRUE(hit);
                EXPECT_LT((Vec3d(hit->position) - e.origin).length(), 1e-5);
                const float side = hit->normal.dot(e.normal);
                // Both patches are in one place, their own sides opposite.
                const bool other = kind == 0 && hit->primitive != light.primitive;
                EXPECT_NEAR(other ? -side : side, 1, 1e-5);
            }
    }
}

/// Vertex normals that lie in the plane say nothing: the winding does.
TEST(AreaLights, normals_that_do_not_decide) {
    TriangleMesh mesh = square();
    mesh.normals.assign(4, Vec3(1, 0, 0));
    for (const bool flip : {false, true}) {
        const auto lights = area_lights_of(emitting(mesh, {}, flip), 0);
        EXPECT_EQ(std::get<EmittingTriangle>(lights[0].surface).normal, Vec3d(0, 0, flip ? -1 : 1));
    }
}

/// Triangles without area keep their numbers and have no power.
TEST(AreaLights, triangles_without_area) {
    TriangleMesh mesh = square();
    mesh.triangles = {{0, 0, 1}, {0, 1, 2}, {1, 1, 1}};
    ShapeDescription shape = emitting(mesh);
    shape.emission->power = 5;
    const auto lights = area_lights_of(shape, 0);
    ASSERT_EQ(lights.size(), 3U);
    for (const std::uint32_t i : {0U, 2U}) {
        EXPECT_EQ(lights[i].power({}), 0);
        EXPECT_EQ(lights[i].primitive, i);
        EXPECT_TRUE(std::isfinite(radiance_of(lights[i])));
    }
    EXPECT_NEAR(flux_of(lights[1]), kRadiance * 5.0, 1e-5);
}

TEST(AreaLights, quadrics_keep_their_place_and_side) {
    const Matrix place = scaled({2, 2, 2}, {1, 2, 3});
    for (const bool flip : {false, true}) {
        const auto sphere = area_lights_of(emitting(Sphere{0.5, -0.5, 0.25, 1}, place, flip), 4);
        ASSERT_EQ(sphere.size(), 1U);
        EXPECT_EQ(sphere[0].shape, 4U);
        EXPECT_EQ(sphere[0].primitive, 0U);
        const auto& ball = std::get<EmittingQuadric<Sphere>>(sphere[0].surface);
        EXPECT_EQ(ball.shape.z_max, 0.25);
        EXPECT_EQ(ball.shape.phi_max, 1);
        EXPECT_EQ(ball.to_world, place);
        EXPECT_EQ(ball.flip, flip);
        EXPECT_NEAR(sphere[0].area(), 4 * 1 * 0.5 * 0.75, 1e-12);

        const auto disk = area_lights_of(emitting(Disk{1, 2, 1, 3}, place, flip), 5);
        ASSERT_EQ(disk.size(), 1U);
        const auto& ring = std::get<EmittingQuadric<Disk>>(disk[0].surface);
        EXPECT_EQ(ring.shape.height, 1);
        EXPECT_EQ(ring.shape.inner_radius, 1);
        EXPECT_EQ(ring.to_world, place);
        EXPECT_EQ(ring.flip, flip);
        EXPECT_NEAR(disk[0].area(), 4 * 1.5 * (4 - 1), 1e-12);
        EXPECT_EQ(radiance_of(disk[0]), kRadiance);
    }
}

/// With "power" every light of the shape emits radiance * power, whatever its size and its sides.
TEST(AreaLights, power_is_spread_over_area_and_sides) {
    for (const bool two_sided : {false, true})
        for (const double scale : {0.1, 1.0, 30.0})
            for (const Shape& shape : {Shape(square()), Shape(Sphere{}), Shape(Disk{})}) {
                ShapeDescription lamp = emitting(shape, scaled(Vec3d(scale), {1, 1, 1}));
                lamp.emission->two_sided = two_sided;
                lamp.emission->power = 12;
                for (const AreaLight& light : area_lights_of(lamp, 0))
                    EXPECT_NEAR(flux_of(light) / (12 * kRadiance), 1, 1e-6) << scale;
                lamp.emission->power = 0;
                for (const AreaLight& light : area_lights_of(lamp, 0)) {
                    EXPECT_EQ(radiance_of(light), kRadiance);
                    EXPECT_NEAR(flux_of(light) / (kPiDouble * light.area() * kRadiance),
                                two_sided ? 2 : 1, 1e-6);
                }
            }
}

TEST(AreaLights, whose_power_over_their_area_is_no_float_are_told_at_their_shape) {
    ShapeDescription shape = emitting(Sphere{1e-15, -1e-15, 1e-15, 2 * kPiDouble});
    shape.where = {"scene.pbrt", 7, 3};
    shape.emission->power = 1e20;
    try {
        area_lights_of(shape, 0);
        FAIL() << "no Error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("scene.pbrt:7:3"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("\"power\""), std::string::npos);
    }
    shape.emission->power = 1;
    EXPECT_NEAR(flux_of(area_lights_of(shape, 0)[0]), kRadiance, 1e-4);
}

}  // namespace
}  // namespace sunfleck::engine
