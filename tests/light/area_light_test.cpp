// Area lights against closed forms: areas, irradiance of disks, spheres and rectangles; sides.
//
// Irradiance by the midpoint rule over the dimensions of sample_direct(): no randomness.
#include "light/area_light.h"

#include "light/partial_emitter.h"
#include "math/warp.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

template <class Surface>
AreaLight light_of(Surface surface, bool two_sided = false) {
    AreaLight light;
    light.surface = surface;
    light.two_sided = two_sided;
    return light;
}

Matrix placed(const Vec3d& move, const Vec3d& scale, double turn_x) {
    Matrix matrix;
    matrix.translate(move);
    matrix.rotate(Vec3d(turn_x, 0, 0));
    matrix.scale(scale);
    return matrix;
}

/// Per unit of radiance, at `point` on a surface with this normal; 512^2 midpoints.
double irradiance(const AreaLight& light, const Vec3& point, const Vec3& normal) {
    constexpr int kSide = 512;
    double sum = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Vec2 u((static_cast<float>(x) + 0.5F) / kSide,
                         (static_cast<float>(y) + 0.5F) / kSide);
            const auto s = light.sample_direct(point, u, {});
            const float cosine = s ? s->direction.dot(normal) : 0;
            if (cosine > 0) sum += static_cast<double>(s->factor * cosine);
        }
    return sum / (kSide * kSide);
}

TEST(AreaLight, disk_on_its_axis) {
    const Disk ring{0.5, 2, 1, 2 * kPiDouble};
    const Matrix down = placed({0, 0, 3}, {1, 1, 1}, kPiDouble);  // faces -z, at z = 2.5
    for (const float z : {-3.0F, 0.0F, 2.0F}) {
        const double h2 = (2.5 - z) * (2.5 - z);
        const double disk = 4 / (4 + h2);
        const double hole = 1 / (1 + h2);
        const AreaLight whole = light_of(EmittingQuadric<Disk>{{0.5, 2}, down});
        EXPECT_NEAR(irradiance(whole, {0, 0, z}, {0, 0, 1}) / (kPiDouble * disk), 1, 1e-4);
        const AreaLight holed = light_of(EmittingQuadric<Disk>{ring, down});
        EXPECT_NEAR(irradiance(holed, {0, 0, z}, {0, 0, 1}) / (kPiDouble * (disk - hole)), 1, 1e-4);
    }
}

/// pi (r / d)^2, at any distance: the directions come from the visible cap.
TEST(AreaLight, sphere_from_outside) {
    const Matrix matrix = placed({1, 2, 3}, Vec3d(0.5), 0.6);
    const AreaLight sphere = light_of(EmittingQuadric<Sphere>{{2, -2, 2}, matrix});  // radius 1
    for (const float d : {1.001F, 1.5F, 10.0F, 10000.0F}) {
        const double expected = kPiDouble / (d * d);
        EXPECT_NEAR(irradiance(sphere, {1, 2 + d, 3}, {0, -1, 0}) / expected, 1, 3e-4) << d;
    }
}

/// Two triangles, seen from below a corner. Source: Howell's catalogue of configuration factors,
/// B-3: element parallel to a rectangle.
/// Half of the points, rounded to floats, lie outside: they would see it as a wall of light.
TEST(AreaLight, sphere_does_not_light_its_own_surface) {
    const Matrix matrix = placed({1, 2, 3}, Vec3d(0.5), 0.6);
    const AreaLight light = light_of(EmittingQuadric<Sphere>{{1, -1, 1, 2 * kPiDouble}, matrix});
    for (int i = 0; i < 20; ++i) {
        const double angle = 0.3 * i;
        const Vec3d out(std::cos(angle), 0.6 * std::sin(angle), 0.8 * std::sin(angle));
        const Vec3 on(Vec3d(1, 2, 3) + out * 0.5);
        const auto s = light.sample_direct(on, {0.3F, 0.6F}, {});
        EXPECT_FALSE(s && s->factor > 0) << i;
    }
}

TEST(AreaLight, rectangle_of_two_triangles) {
    const double a = 1.5;
    const double b = 0.7;
    const double c = 0.8;
    EmittingTriangle first{Vec3d(0, 0, c), Vec3d(a, 0, 0), Vec3d(a, b, 0), Vec3d(0, 0, -1)};
    EmittingTriangle second{Vec3d(0, 0, c), Vec3d(a, b, 0), Vec3d(0, b, 0), Vec3d(0, 0, -1)};
    const double got = irradiance(light_of(first), Vec3(0), {0, 0, 1}) +
                       irradiance(light_of(second), Vec3(0), {0, 0, 1});
    const double x = a / c;
    const double y = b / c;
    const double p = std::sqrt(1 + x * x);
    const double q = std::sqrt(1 + y * y);
    const double factor = (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * kPiDouble);
    EXPECT_NEAR(got / (kPiDouble * factor), 1, 1e-4);
}

/// pi from all sides, wherever one stands in a hollow sphere.
TEST(AreaLight, hollow_sphere_from_inside) {
    const Matrix matrix = placed({1, 2, 3}, Vec3d(1.5), 0);
    const AreaLight hollow = light_of(EmittingQuadric<Sphere>{{}, matrix, true});
    EXPECT_NEAR(irradiance(hollow, {1, 2.3F, 2.5F}, {0, 0, 1}), kPiDouble, 1e-3);
    EXPECT_FALSE(hollow.sample_direct({1, 2, 5}, {.3F, .4F}, {}));
    EXPECT_EQ(hollow.direct_pdf({1, 2, 5}, {1, 2, 4.5F}, {0, 0, -1}), 0);
}

TEST(AreaLight, two_sided_sphere_shines_out_and_in) {
    const AreaLight sphere = light_of(EmittingQuadric<Sphere>{{}, Matrix()}, true);
    EXPECT_NEAR(irradiance(sphere, {0, 0, -2}, {0, 0, 1}), kPiDouble / 4, 1e-4);
    EXPECT_NEAR(irradiance(sphere, {0.2F, 0, 0.3F}, {0, 1, 0}), kPiDouble, 1e-3);
    // Its far inner side is hidden by the near one: nothing is sampled there.
    EXPECT_GT(sphere.direct_pdf({0, 0, -2}, {0, 0, -1}, {0, 0, -1}), 0);
    EXPECT_EQ(sphere.direct_pdf({0, 0, -2}, {0, 0, 1}, {0, 0, 1}), 0);
    const AreaLight flipped = light_of(EmittingQuadric<Sphere>{{}, Matrix(), true}, true);
    EXPECT_NEAR(irradiance(flipped, {0, 0, -2}, {0, 0, 1}), kPiDouble / 4, 1e-4);
    EXPECT_GT(flipped.direct_pdf({0, 0, -2}, {0, 0, -1}, {0, 0, 1}), 0);
}

TEST(AreaLight, one_sided_ones_are_dark_behind) {
    const EmittingTriangle triangle{Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    for (const bool two_sided : {false, true}) {
        const AreaLight light = light_of(triangle, two_sided);
        EXPECT_TRUE(light.sample_direct({0, 0, 1}, {.3F, .4F}, {}));
        EXPECT_EQ(two_sided, light.sample_direct({0, 0, -1}, {.3F, .4F}, {}).has_value());
        EXPECT_EQ(two_sided, light.direct_pdf({0, 0, -1}, {.1F, .1F, 0}, {0, 0, 1}) > 0);
        EXPECT_EQ(two_sided, light.emits({0, 0, 1}, {0, 0.6F, -0.8F}));
        EXPECT_TRUE(light.emits({0, 0, 1}, {0, 0.6F, 0.8F}));
        // In its own plane, and on a point of it: nothing, and no NaN.
        EXPECT_FALSE(light.sample_direct({3, 3, 0}, {.3F, .4F}, {}));
        EXPECT_EQ(light.direct_pdf({.1F, .1F, 0}, {.1F, .1F, 0}, {0, 0, 1}), 0);
    }
}

/// The two halves of the dimension meet at the horizon, and so do its two ends.
TEST(AreaLight, two_sides_share_the_dimension_without_a_jump) {
    const EmittingTriangle triangle{Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    const AreaLight light = light_of(triangle, true);
    const auto direction = [&](double u) {
        return light.sample_emission({0.5, 0.25, u, 0.4}, {}).direction;
    };
    EXPECT_GT(direction(0.2).z, 0.3);
    EXPECT_LT(direction(0.7).z, -0.3);
    EXPECT_LT((direction(0.5 - 1e-12) - direction(0.5 + 1e-12)).length(), 1e-5);
    EXPECT_LT((direction(1e-12) - direction(1 - 1e-12)).length(), 1e-5);
    EXPECT_EQ(light.sample_emission({0.5, 0.25, 0.9, 0.4}, {}).normal, Vec3(0, 0, 1));
}

TEST(AreaLight, areas_are_the_closed_forms) {
    const EmittingTriangle triangle{Vec3d(5), Vec3d(3, 0, 0), Vec3d(1, 2, 0), Vec3d(0, 0, 1)};
    EXPECT_NEAR(light_of(triangle).area(), 3, 1e-14);
    EXPECT_NEAR(light_of(triangle).power({}), 3 * kPiDouble, 1e-13);
    EXPECT_NEAR(light_of(triangle, true).power({}), 6 * kPiDouble, 1e-13);

    const Matrix mirrored = placed({1, 2, 3}, {-2, 2, 2}, 1);
    const Sphere zone{1.5, -0.5, 1, 3};
    EXPECT_NEAR(light_of(EmittingQuadric<Sphere>{zone, mirrored}).area(), 4 * 1.5 * 1.5 * 3, 1e-9);

    // Oblate and prolate spheroids, half axes 1, 1, c.
    const Matrix oblate = placed({1, 2, 3}, {1, 1, 0.2}, 0.5);
    const double e = std::sqrt(1 - 0.04);
    EXPECT_NEAR(light_of(EmittingQuadric<Sphere>{{}, oblate}).area(),
                2 * kPiDouble * (1 + 0.04 / e * std::atanh(e)), 1e-4);
    const Matrix prolate = placed({1, 2, 3}, {1, 1, 3}, 0.5);
    const double f = std::sqrt(1 - 1.0 / 9);
    EXPECT_NEAR(light_of(EmittingQuadric<Sphere>{{}, prolate}).area(),
                2 * kPiDouble * (1 + 3 / f * std::asin(f)), 1e-4);

    Matrix sheared;
    sheared[2][0] = 5;  // along z, which a disk has not
    sheared[1][0] = 0.5;
    sheared[1][2] = 2;
    const Disk sector{1, 2, 1, 1.5};
    EXPECT_NEAR(light_of(EmittingQuadric<Disk>{sector, sheared}).area(), 0.75 * 3 * std::sqrt(5.0),
                1e-9);
}

/// Rays do not meet it, so its light samples are not weighed against any.
TEST(AreaLight, that_nothing_meets_is_sampled_as_a_point_light) {
    AreaLight light;
    light.curve = Spectrum::constant(1);
    light.surface = EmittingQuadric<Disk>{Disk{0, 1, 0, 2 * kPiDouble}, Matrix()};
    const auto seen = light.sample_direct({0, 0, 1}, {0.3F, 0.6F}, {});
    light.unseen = true;
    const auto unseen = light.sample_direct({0, 0, 1}, {0.3F, 0.6F}, {});
    ASSERT_TRUE(seen && unseen);
    EXPECT_TRUE(seen->pdf);
    EXPECT_FALSE(unseen->pdf);
    EXPECT_EQ(seen->factor, unseen->factor);
}

/// A third of it is there at the left, all of it at the right: power, light samples, emission.
TEST(AreaLight, that_is_there_in_part_shines_as_far_as_it_is) {
    const Cover cover = [](const Hit& hit) { return hit.uv.x < 0.5F ? 1.0F / 3 : 1.0F; };
    AreaLight light = light_of(EmittingTriangle{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const double whole_power = light.power({});
    const AreaLight whole = light;
    light.alpha = std::make_shared<const PartialEmitter>(
        cover, CornerUvs{Vec2(0, 0), Vec2(1, 0), Vec2(0, 0)}, light.surface);
    EXPECT_NEAR(light.power({}) / whole_power, 0.5, 0.02);  // a quarter of the area is right
    for (const float u : {0.1F, 0.33F, 0.77F, 0.95F}) {
        const auto part = light.sample_direct({0.5F, 0.2F, 1}, {u, 0.4F}, {});
        const auto all = whole.sample_direct({0.5F, 0.2F, 1}, {u, 0.4F}, {});
        ASSERT_TRUE(part && all);
        const float x = 0.5F + part->direction.x * part->distance;
        EXPECT_NEAR(part->factor / all->factor, x < 1 ? 1.0F / 3 : 1.0F, 1e-5F) << x;
        const EmissionDimensions numbers = {u, 0.4, 0.3, 0.2};
        const Emission emitted = light.sample_emission(numbers, {});
        EXPECT_NEAR(emitted.factor / whole.sample_emission(numbers, {}).factor,
                    emitted.origin.x < 1 ? 1.0 / 3 : 1.0, 1e-5);
    }
}

}  // namespace
}  // namespace sunfleck::engine
