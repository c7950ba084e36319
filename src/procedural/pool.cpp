// A tiled pool with waves, a jar and rings on its ground; the camera is in the water.

#include "procedural/pool.h"

#include "math/trigonometry.h"
#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/surfaces.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kPoolHead = {.unit = "Unit: metres; z is up",
                                 .camera = R"(MediumInterface "" "water"
LookAt -1.5 0.5 0.85  0.35 4.6 0.82  0 0 1
Camera "perspective" "float fov" 62
)",
                                 .width = 640,
                                 .height = 480,
                                 .max_depth = 32};

constexpr std::string_view kPoolMaterials = R"(
# The sun, 47 degrees high: perpendicular irradiance 38; and an even sky.
LightSource "distant" "point3 from" [ 0.42 0.55 0.72 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.95 0.87 ] "float scale" 38
LightSource "infinite" "rgb L" [ 0.32 0.5 0.75 ] "float scale" 0.6

# Murky water: grains scatter forwards, and red light is absorbed first. Per metre.
MakeNamedMedium "water" "string type" "homogeneous"
    "rgb sigma_s" [ 0.15 0.16 0.17 ] "rgb sigma_a" [ 0.16 0.04 0.045 ] "float g" 0.8

Texture "tiles" "spectrum" "checkerboard" "string mapping" "planar"
    "vector3 v1" [ 2.5 0 0 ] "vector3 v2" [ 0 2.5 0 ]
    "rgb tex1" [ 0.5 0.56 0.54 ] "rgb tex2" [ 0.32 0.44 0.46 ]
Texture "side tiles" "spectrum" "checkerboard" "string mapping" "planar"
    "vector3 v1" [ 0 2.5 0 ] "vector3 v2" [ 0 0 2.5 ]
    "rgb tex1" [ 0.5 0.56 0.54 ] "rgb tex2" [ 0.32 0.44 0.46 ]
MakeNamedMaterial "tiles" "string type" "diffuse" "texture reflectance" "tiles"
MakeNamedMaterial "side tiles" "string type" "diffuse" "texture reflectance" "side tiles"
MakeNamedMaterial "stone" "string type" "diffuse" "rgb reflectance" [ 0.7 0.68 0.62 ]
MakeNamedMaterial "clay" "string type" "diffuse" "rgb reflectance" [ 0.66 0.33 0.19 ]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ 0.75 0.12 0.08 ]
MakeNamedMaterial "yellow" "string type" "diffuse" "rgb reflectance" [ 0.85 0.62 0.08 ]
MakeNamedMaterial "water" "string type" "dielectric" "float eta" 1.333
)";

// The pool: x from -2.5 to 2.5, y from 0 to 9; its ground is at z = 0, the water's level at 1.8.
constexpr double kPoolLevel = 1.8;
// Centres of the square openings in the roof.
constexpr std::array<std::array<double, 2>, 4> kRoofOpenings = {
    {{1.7, 5.7}, {0.35, 4.15}, {1.4, 8}, {-0.4, 6.9}}};

/// One of the waves that add up: its height over the mean level, and full waves per metre.
struct PoolWave {
    double height;
    double along_x;
    double along_y;
    double phase;  // in full waves
};

constexpr std::array<PoolWave, 8> kPoolWaves = {{{0.016, 0.62, 0.38, 0.1},
                                                 {0.013, -0.5, 0.84, 0.45},
                                                 {0.0075, 1.22, -0.55, 0.8},
                                                 {0.006, 0.42, 1.56, 0.25},
                                                 {0.0036, -1.9, 0.83, 0.6},
                                                 {0.0026, 1.64, 1.81, 0.05},
                                                 {0.0015, 2.9, -1.4, 0.35},
                                                 {0.0012, -1.3, -3.3, 0.7}}};

struct PoolPoint {
    Vec3d position;
    Vec3d normal;
};

PoolPoint pool_surface(double x, double y) {
    PoolPoint point = {{x, y, kPoolLevel}, {0, 0, 1}};
    for (const PoolWave& wave : kPoolWaves) {
        const SinCos t = sin_cos_2pi(wave.along_x * x + wave.along_y * y + wave.phase);
        point.position.z += wave.height * t.sin;
        const double slope = 2 * kPiDouble * wave.height * t.cos;
        point.normal -= Vec3d(slope * wave.along_x, slope * wave.along_y, 0);
    }
    point.normal.normalize();
    return point;
}

constexpr std::uint32_t kAcross = 130;  // cells of 4 cm
constexpr std::uint32_t kAlong = 230;

std::uint32_t pool_index(std::uint32_t column, std::uint32_t row) {
    return row * (kAcross + 1) + column;
}

/// Returns the border of the grid, counter-clockwise from above.
std::vector<std::uint32_t> pool_border() {
    std::vector<std::uint32_t> border;
    for (std::uint32_t i = 0; i < kAcross; ++i) border.push_back(pool_index(i, 0));
    for (std::uint32_t j = 0; j < kAlong; ++j) border.push_back(pool_index(kAcross, j));
    for (std::uint32_t i = kAcross; i > 0; --i) border.push_back(pool_index(i, kAlong));
    for (std::uint32_t j = kAlong; j > 0; --j) border.push_back(pool_index(0, j));
    return border;
}

/// Adds sides below the border and a fan as the bottom.
void close_below(Mesh& water, const std::vector<std::uint32_t>& border, float bottom) {
    const auto add = [&](std::array<float, 3> point, const std::array<float, 3>& normal) {
        water.points.push_back(point);
        water.normals.push_back(normal);
        return static_cast<std::uint32_t>(water.points.size() - 1);
    };
    const std::uint32_t middle = add({0, 4.5F, bottom}, {0, 0, -1});
    for (std::size_t i = 0; i < border.size(); ++i) {
        const std::array<float, 3> a = water.points[border[i]];
        const std::array<float, 3> b = water.points[border[(i + 1) % border.size()]];
        const Vec3d side = Vec3d(b[1] - a[1], a[0] - b[0], 0).normalized();
        const std::array<float, 3> out = rounded_point(side);
        const std::array<float, 3> under_a = {a[0], a[1], bottom};
        const std::array<float, 3> under_b = {b[0], b[1], bottom};
        const std::uint32_t first = add(a, out);
        add(under_a, out);
        add(under_b, out);
        add(b, out);
        water.add_quad(first, first + 1, first + 2, first + 3);
        const std::uint32_t edge = add(under_a, {0, 0, -1});
        add(under_b, {0, 0, -1});
        water.triangles.push_back({middle, edge + 1, edge});
    }
}

void add_pool(SceneFolder& folder) {
    folder.add("ground", "tiles", box_mesh({-2.9F, -0.4F, -0.3F}, {2.9F, 9.4F, 0}));
    folder.add("left wall", "side tiles", box_mesh({-3.5F, -0.5F, -0.29F}, {-2.5F, 9.5F, 2.7F}));
    folder.add("right wall", "side tiles", box_mesh({2.5F, -0.5F, -0.29F}, {3.5F, 9.5F, 2.7F}));
    folder.add("near wall", "stone", box_mesh({-3.49F, -1, -0.28F}, {3.49F, 0, 2.69F}));
    folder.add("far wall", "stone", box_mesh({-3.49F, 9, -0.28F}, {3.49F, 10, 2.69F}));
    std::vector<Polygon> openings;
    for (const auto& [x, y] : kRoofOpenings)
        openings.push_back(rectangle(x - 0.5, y - 0.5, x + 0.5, y + 0.5));
    folder.add("pool-roof", "stone", extrude(rectangle(-3.2, -0.7, 3.2, 9.7), openings, 2.6, 2.8));
    Mesh steps;
    for (int i = 0; i < 4; ++i) {
        const auto step = static_cast<float>(i);
        steps.append(box_mesh({-2.55F - 0.01F * step, 7.4F + 0.35F * step, -0.05F - 0.01F * step},
                              {2.55F + 0.01F * step, 9.05F + 0.01F * step, 0.35F * (step + 1)}));
    }
    folder.add("steps", "stone", steps);
}

Mesh pool_jar() {
    Profile profile = {{0, 0}, {0.1, 0}};
    append_bezier(profile, {{{0.34, 0.28}, {0.3, 0.62}, {0.1, 0.78}}}, 24);
    append_bezier(profile, {{{0.08, 0.86}, {0.09, 0.92}, {0.15, 0.96}}}, 10);
    append_bezier(profile, {{{0.12, 0.93}, {0.06, 0.87}, {0.08, 0.78}}}, 10);
    append_bezier(profile, {{{0.26, 0.6}, {0.3, 0.3}, {0, 0.05}}}, 20);
    return revolve(profile, 64);
}

}  // namespace

Mesh pool_water() {
    Mesh water;
    for (std::uint32_t row = 0; row <= kAlong; ++row)
        for (std::uint32_t column = 0; column <= kAcross; ++column) {
            const PoolPoint point = pool_surface(-2.6 + 0.04 * column, -0.1 + 0.04 * row);
            water.points.push_back(rounded_point(point.position));
            water.normals.push_back(rounded_point(point.normal));
        }
    for (std::uint32_t row = 0; row < kAlong; ++row)
        for (std::uint32_t column = 0; column < kAcross; ++column)
            water.add_quad(pool_index(column, row), pool_index(column + 1, row),
                           pool_index(column + 1, row + 1), pool_index(column, row + 1));
    close_below(water, pool_border(), -0.1F);
    return water;
}

std::vector<SceneFile> pool_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kPoolHead);
    folder.text(kPoolMaterials);
    add_pool(folder);
    folder.text("\nAttributeBegin\nMediumInterface \"water\" \"\"");
    folder.add("pool-water", "water", pool_water());
    folder.text("AttributeEnd\n");
    folder.add("pool-jar", "clay", placed(pool_jar(), at({0.55, 4.3, 0.001})));
    folder.add("red-ring", "red", placed(torus(0.16, 0.022, 96, 24), at({-0.75, 2.7, 0.023})));
    folder.add("yellow-ring", "yellow",
               placed(torus(0.16, 0.022, 96, 24), at({-0.3, 3.35, 0.023})));
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
