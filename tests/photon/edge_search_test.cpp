// A hole of a tenth of a millimetre is found by its edges, whatever they are edges of.
#include "photon/edge_search.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr double kHalf = 5e-5;  // of the hole's side
constexpr float kTop = 1;       // where the plate with the hole is

/// A square around a smaller one: corners 0 to 3, and 4 to 7 within.
std::vector<Vec3> frame_corners() {
    std::vector<Vec3> corners;
    for (const float half : {2.0F, static_cast<float>(kHalf)})
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
            corners.emplace_back(static_cast<float>(x) * half, static_cast<float>(y) * half, kTop);
    return corners;
}

Shape of_triangles() {
    TriangleMesh mesh;
    mesh.positions = frame_corners();
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        mesh.triangles.push_back({i, j, 4 + j});
        mesh.triangles.push_back({i, 4 + j, 4 + i});
    }
    return mesh;
}

Shape of_patches() {
    BilinearMesh mesh;
    mesh.positions = frame_corners();
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        mesh.patches.push_back({i, j, 4 + i, 4 + j});
    }
    return mesh;
}

/// A floor of many triangles, for few of all edges to be those of the hole.
Shape grid() {
    constexpr std::uint32_t kSide = 150;
    TriangleMesh mesh;
    for (std::uint32_t y = 0; y <= kSide; ++y)
        for (std::uint32_t x = 0; x <= kSide; ++x)
            mesh.positions.emplace_back(static_cast<float>(x) / kSide - 0.5F,
                                        static_cast<float>(y) / kSide - 0.5F, 0);
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const std::uint32_t i = y * (kSide + 1) + x;
            mesh.triangles.push_back({i, i + 1, i + kSide + 2});
            mesh.triangles.push_back({i, i + kSide + 2, i + kSide + 1});
        }
    return mesh;
}

ShapeDescription described(const Shape& shape, const Matrix& to_world = {}) {
    return {{shape, to_world, false}, 0, {}, {}};
}

/// Below the sun, which shines straight down.
SceneDescription scene_below_the_sun(std::vector<ShapeDescription> shapes) {
    SceneDescription scene;
    scene.materials = {DiffuseMaterial{Spectrum::constant(0.5F)}};
    scene.shapes = std::move(shapes);
    scene.lights = {DistantLight{Spectrum::constant(1), {0, 0, -1}}};
    return scene;
}

struct Found {
    std::size_t all = 0;
    std::size_t through_hole = 0;
};

/// By 20,000 tries.
Found found_in(const SceneDescription& description) {
    const PassId id{5, 0};
    const Scene scene(description);
    const PassScene pass(scene, id);
    const TransportSettings transport;
    const VisiblePointIndex index({}, 8);
    const PhotonContext view{pass, transport, index};
    Found found;
    for (const auto& [point, weight] :
         emission_past_edges(view, scene.light_choice(), id, {0, 20'000})) {
        const Emission start = sample_emission(
            scene.lights()[0], {point[0], point[1], point[2], point[3]}, scene.sphere());
        ++found.all;
        if (std::abs(start.origin.x) < kHalf && std::abs(start.origin.y) < kHalf)
            ++found.through_hole;
    }
    return found;
}

// Of uniform paths one in 2 x 10^9 goes through the hole.
TEST(EdgeSearch, finds_a_hole_between_triangles_or_patches) {
    for (const Shape& plate : {of_triangles(), of_patches()}) {
        const Found found = found_in(scene_below_the_sun({described(plate)}));
        EXPECT_GT(found.through_hole, 200U);
        EXPECT_GT(found.all, found.through_hole);  // the plate's outer edges
        EXPECT_LT(found.all, 15'000U);             // what is below the plate is not lit
    }
}

TEST(EdgeSearch, finds_it_where_nearly_all_edges_are_of_something_else) {
    const Found found =
        found_in(scene_below_the_sun({described(grid()), described(of_triangles())}));
    EXPECT_GT(found.through_hole, 200U);
}

// The plate stands on edge, as wide as one, in an object that is turned and made twice as large.
TEST(EdgeSearch, finds_it_where_instances_stand) {
    Matrix smaller;
    smaller.scale(Vec3(0.5F, 0.5F, 1));
    Matrix on_edge;
    on_edge.rotate(Vec3(static_cast<float>(kPi / 2), 0, 0));
    Matrix back;
    back.rotate(Vec3(static_cast<float>(-kPi / 2), 0, 0));
    back.scale(Vec3(2, 1, 2));
    SceneDescription scene = scene_below_the_sun({});
    scene.objects = {{described(of_triangles(), smaller * on_edge)}};
    scene.instances = {{0, back}};
    EXPECT_GT(found_in(scene).through_hole, 200U);
}

TEST(EdgeSearch, finds_nothing_where_there_are_no_edges) {
    EXPECT_EQ(found_in(scene_below_the_sun({described(Sphere{1})})).all, 0U);
}

// Such triangles cannot be hit (geometry/geometry.h).
TEST(EdgeSearch, leaves_out_triangles_with_corners_that_are_not_there) {
    TriangleMesh mesh;
    mesh.positions = frame_corners();
    mesh.triangles = {{0, 1, 99}, {97, 98, 99}, {0, 1, 2}};
    EXPECT_GT(found_in(scene_below_the_sun({described(mesh)})).all, 1'000U);
}

}  // namespace
}  // namespace sunfleck::engine
