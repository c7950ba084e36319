// One or more lights of every kind, each with a small disc that it lights. The light laws run
// over all of them; a new kind of light without an example does not pass.
#pragma once

#include "light/light.h"
#include "light/surface_image.h"
#include "math/warp.h"
#include "medium/density_samples.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace sunfleck::engine::testing_support {

/// What the examples light stands in this sphere.
inline const SceneSphere kExampleSphere = {Vec3d(0.5, -0.25, 1), 2.5};

struct LightExample {
    std::string name;
    /// Only the test that looks makes it: the colours of a picture take their time.
    std::function<Light()> make;
    /// A disc of radius 0.5 that sees the light on its front, unhindered by the light itself.
    Vec3 point{0.3F, 0.2F, 0};
    Vec3 normal{0, 0, 1};

    friend std::ostream& operator<<(std::ostream& out, const LightExample& example) {
        return out << example.name;
    }
};

inline Matrix placed(const Vec3d& move, const Vec3d& scale, double turn_x, double turn_z) {
    Matrix matrix;
    matrix.translate(move);
    matrix.rotate(Vec3d(0, 0, turn_z));
    matrix.rotate(Vec3d(turn_x, 0, 0));
    matrix.scale(scale);
    return matrix;
}

template <class Surface>
LightExample area_example(std::string name, Surface surface, bool two_sided = false) {
    AreaLight light;
    light.surface = surface;
    light.two_sided = two_sided;
    return {std::move(name), [light] { return light; }};
}

inline LightExample plain_example(std::string name, const Light& light) {
    return {std::move(name), [light] { return light; }};
}

inline EmittingTriangle example_triangle(bool facing_down) {
    EmittingTriangle t{Vec3d(-1, -0.5, 2), Vec3d(2.5, 0.2, 0.4), Vec3d(0.1, 1.8, -0.3), {}};
    t.normal = t.edge1.cross(t.edge2).normalized() * (facing_down ? -1 : 1);
    return t;
}

inline std::vector<LightExample> sphere_examples() {
    const Matrix above = placed({0.2, 0.1, 2.2}, Vec3d(0.8), 0.7, 0.3);
    const Matrix mirrored = placed({-0.5, 0.4, 2}, {0.8, -0.8, 0.8}, -0.4, 1);
    const Matrix uneven = placed({0.4, 0.1, 2.4}, {0.6, 1.2, 0.9}, 0.5, -0.6);
    Sphere zone;
    zone.z_min = -0.8;
    zone.z_max = 0.4;
    zone.phi_max = 4;
    std::vector<LightExample> all;
    all.push_back(area_example("sphere", EmittingQuadric<Sphere>{{}, above}));
    all.push_back(area_example("mirrored_sphere", EmittingQuadric<Sphere>{{}, mirrored}));
    all.push_back(area_example("sphere_zone", EmittingQuadric<Sphere>{zone, above}, true));
    all.push_back(area_example("mirrored_zone", EmittingQuadric<Sphere>{zone, mirrored, true}));
    all.push_back(area_example("ellipsoid", EmittingQuadric<Sphere>{{}, uneven}));
    // Seen from inside.
    const Matrix around = placed({0, 0, 0.2}, Vec3d(1.7), 0.2, 0.1);
    all.push_back(area_example("hollow_sphere", EmittingQuadric<Sphere>{{}, around, true}));
    const Matrix egg = placed({0, 0, 0.3}, {1.2, 2, 1.5}, 0.2, 0.1);
    all.push_back(area_example("hollow_egg", EmittingQuadric<Sphere>{{}, egg, true}));
    return all;
}

inline std::vector<LightExample> disk_examples() {
    Disk sector;
    sector.height = 0.25;
    sector.radius = 1.4;
    sector.inner_radius = 0.5;
    sector.phi_max = 5;
    Matrix sheared = placed({-0.2, 0.1, 1.8}, {1, 1.3, 1}, 0.4, 0.2);
    sheared[1][0] += 0.5;
    const Matrix facing_down = placed({0, 0.3, 2}, {0.9, 0.9, -1}, kPiDouble + 0.3, 0);
    std::vector<LightExample> all;
    all.push_back(area_example("disk", EmittingQuadric<Disk>{{}, facing_down, true}));
    all.push_back(area_example("sector", EmittingQuadric<Disk>{sector, sheared, true}));
    all.push_back(area_example("two_sided_sector", EmittingQuadric<Disk>{sector, sheared}, true));
    return all;
}

inline std::vector<LightExample> cylinder_examples() {
    const Matrix across = placed({-0.3, 0.8, 2}, {0.5, 0.5, 0.8}, 1.3, 0.3);
    Matrix sheared = placed({0.2, -0.4, 2.2}, {0.4, -0.7, 0.8}, 1.1, -0.5);
    sheared[2][0] += 0.3;
    Cylinder part;
    part.z_min = -0.7;
    part.phi_max = 4;
    std::vector<LightExample> all;
    all.push_back(area_example("cylinder", EmittingQuadric<Cylinder>{{}, across}));
    all.push_back(area_example("sheared_part", EmittingQuadric<Cylinder>{part, sheared}, true));
    // A trough, its hollow side down.
    Cylinder half;
    half.phi_max = kPiDouble;
    const Matrix over = placed({0.1, 0.2, 1.2}, {0.9, 1.1, 0.8}, kPiDouble / 2, 0.4);
    all.push_back(area_example("trough", EmittingQuadric<Cylinder>{half, over, true}));
    return all;
}

inline std::vector<LightExample> patch_examples() {
    const Bilinear twisted{
        {Vec3d(-1, -0.8, 2), Vec3d(1, -0.9, 2.5), Vec3d(-0.6, 0.7, 2.6), Vec3d(0.8, 0.9, 1.9)}};
    const Bilinear flat{
        {Vec3d(-1, -0.8, 2), Vec3d(1, -0.9, 2.2), Vec3d(-0.3, 0.7, 2.07), Vec3d(0.5, 0.9, 0)}};
    Bilinear trapezoid = flat;  // p11 into the plane of the others
    const Vec3d normal = (flat.corner[1] - flat.corner[0]).cross(flat.corner[2] - flat.corner[0]);
    trapezoid.corner[3].z =
        flat.corner[0].z -
        (normal.x * (0.5 - flat.corner[0].x) + normal.y * (0.9 - flat.corner[0].y)) / normal.z;
    Bilinear triangle = twisted;
    triangle.corner[3] = triangle.corner[2];
    EmittingPatch smooth{twisted};
    smooth.normals.fill(Vec3d(0.2, 0.1, -1));
    std::vector<LightExample> all;
    all.push_back(area_example("patch", EmittingPatch{twisted, true}));
    all.push_back(area_example("two_sided_patch", EmittingPatch{twisted}, true));
    all.push_back(area_example("patch_with_normals", smooth));
    all.push_back(area_example("trapezoid", EmittingPatch{trapezoid, true}));
    all.push_back(area_example("patch_with_a_point", EmittingPatch{triangle, true}));
    return all;
}

/// A coloured sky with a sun, a black stripe and a black corner. @param side  its height.
/// @param wide  width over height.
inline Image example_image(int side, int wide = 1) {
    std::vector<float> texels;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side * wide; ++x) {
            const bool black = y == side / 3 || (x == 0 && y == 0);
            const float sun = x == side / 2 && y == side / 2 + 1 ? 20.0F : 0.0F;
            const auto part = [&](int a) {
                return static_cast<float>(a) / static_cast<float>(side);
            };
            for (const float c : {0.2F + part(x), 0.5F, 1.5F - part(y)})
                texels.push_back(black ? 0 : c + sun);
        }
    return {{side * wide, side}, 3, texels};
}

inline std::shared_ptr<const LightImage> example_sky(int side) {
    return std::make_shared<const LightImage>(example_image(side));
}

/// A window in the ceiling, under a sky that has a sun and colours.
inline Light example_portal() {
    const Image image = example_image(9);
    const auto picture = std::make_shared<const PortalImage>(64, [&image](const Vec3d& w) {
        const Vec2d place = sphere_to_square(w) * 9;
        return image.rgb(std::min(static_cast<int>(place.x), 8),
                         std::min(static_cast<int>(place.y), 8));
    });
    const Affine above(placed({-0.4, -0.6, 1.2}, Vec3d(1), 0.2, 0.3));
    return PortalLight{{}, picture, above, {1.3, 1.9}};
}

/// A part of a wall far away.
inline Light example_portal_aside() {
    const auto picture =
        std::make_shared<const PortalImage>(48, [](const Vec3d&) { return Vec3(1); });
    const Affine wall(placed({-1.2, 0.6, 1.1}, Vec3d(1), -0.7, 0.2));
    return PortalLight{{}, picture, wall, {2.5, 1.1}};
}

inline std::vector<LightExample> infinite_examples() {
    const Affine turned(placed({0, 0, 0}, Vec3d(1), 0.7, -0.4));
    const Affine mirrored(placed({0, 0, 0}, {1, 1, -1}, 0.2, 1.3));
    return {plain_example("infinite", InfiniteLight{}),
            {"sky",
             [=] {
                 return ImageInfiniteLight{{}, example_sky(9), turned};
             }},
            {"mirrored_sky",
             [=] {
                 return ImageInfiniteLight{{}, example_sky(4), mirrored};
             }},
            {"latitudes",
             [=] {
                 const DirectionMap map = DirectionMap::latitude_longitude(6);
                 return ImageInfiniteLight{
                     {}, image_of_directions(example_image(6, 2), map), mirrored, map};
             }},
            {"wide_sun",
             [] {
                 return SunLight{{},
                                 Vec3d(0.4, 0.5, -1).normalized(),
                                 0.9,
                                 normalised_darkening({0.3, 0.9, -0.2, 0, 0, 0})};
             }},
            {"portal", example_portal},
            {"portal_aside", example_portal_aside}};
}

inline std::vector<LightExample> picture_examples() {
    const Affine mirrored(placed({0, 0, 0}, {1, 1, -1}, 0.2, 1.3));
    const Affine down(placed({0, 0, 0}, Vec3d(1), kPiDouble + 0.2, 0.5));
    const Vec3d above(0.6, -0.2, 1.5);
    const Vec2d half(0.6, 0.6);
    return {
        {"goniometric",
         [=] {
             return GoniometricLight{{}, above, example_sky(6), mirrored};
         }},
        {"projection",
         [=] {
             const auto slide = projected_image(example_image(7), half);
             return ProjectionLight{{}, above, half, slide, down};
         }},
    };
}

/// Surfaces of every kind, each with the same picture on it.
inline std::vector<LightExample> pictured_examples() {
    std::vector<LightExample> all;
    const auto add = [&](const std::string& name, const LightExample& plain) {
        all.push_back(
            {"pictured_" + name, [plain] {
                 const CornerUvs uvs{Vec2(0.1F, 0), Vec2(1.2F, 0.3F), Vec2(0, 1), Vec2(0.9F, 1)};
                 auto light = std::get<AreaLight>(plain.make());
                 light.image = std::make_shared<const PlacedImage>(
                     std::make_shared<const SurfaceImage>(example_image(5)), uvs, light.surface,
                     1 << 22);
                 return light;
             }});
    };
    add("triangle", area_example("", example_triangle(true)));
    add("sphere", sphere_examples()[0]);
    add("ellipsoid", sphere_examples()[4]);
    add("disk", disk_examples()[2]);
    add("trough", cylinder_examples()[2]);
    add("patch", patch_examples()[0]);
    return all;
}

/// A sphere that rays do not hit and that shines within, too. @param flip  only within.
inline Light unseen_sphere(bool flip) {
    AreaLight light;
    light.surface =
        EmittingQuadric<Sphere>{{}, placed({0.2, 0.1, 2.2}, Vec3d(0.8), 0.7, 0.3), flip};
    light.two_sided = !flip;
    light.unseen = true;
    return light;
}

/// Glowing smoke in a box above the disc, dark in a corner.
inline Light example_smoke() {
    std::vector<float> values(std::size_t{4} * 3 * 5);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = i % 4 == 3 || i > 50 ? 0 : 1 + static_cast<float>(i * 7 % 5);
    const Affine box(placed({-0.6, -0.4, 1.1}, {1.4, 1.1, 0.8}, 0.3, 0.5));
    return MediumLight({}, 1, density_of_points(values, {3, 2, 4}, box).whole());
}

inline std::vector<LightExample> light_examples() {
    std::vector<LightExample> all = infinite_examples();
    all.push_back(plain_example("point", PointLight{{}, Vec3d(0.8, -0.3, 1.4)}));
    SpotLight spot{{}, Vec3d(0.2, 0.3, 2), Vec3d(0.3, -0.2, -1).normalized()};
    spot.cos_total = std::cos(0.9);
    spot.cos_start = std::cos(0.3);
    all.push_back(plain_example("spot", spot));
    spot.cos_start = spot.cos_total = std::cos(0.35);
    all.push_back(plain_example("sharp_spot", spot));
    spot.cos_start = std::cos(0.1);
    spot.cos_total = std::cos(0.8);
    spot.edge = SpotEdge::square;
    all.push_back(plain_example("spot_with_square_edge", spot));
    spot.edge = SpotEdge::smoothstep;
    spot.cos_start = 1;
    spot.cos_total = -0.5;
    all.push_back(plain_example("spot_without_core", spot));
    all.push_back(plain_example("distant", DistantLight{{}, Vec3d(0.4, 0.5, -1).normalized()}));
    all.push_back({"smoke", example_smoke});
    all.push_back({"unseen_sphere", [] { return unseen_sphere(false); }, {0.3F, 0.2F, 0.5F}});
    all.push_back({"unseen_sphere_within", [] { return unseen_sphere(true); }, {0.1F, 0.2F, 1.9F}});
    all.push_back(area_example("triangle", example_triangle(true)));
    all.push_back(area_example("two_sided_triangle", example_triangle(false), true));
    for (const auto& more : {picture_examples(), sphere_examples(), disk_examples(),
                             cylinder_examples(), patch_examples(), pictured_examples()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace sunfleck::engine::testing_support
