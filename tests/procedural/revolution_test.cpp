// Surfaces of revolution: closed, oriented, of the volume that a prism or pyramid has.

#include "procedural/revolution.h"

#include "mesh_checks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kSegments = 7;

/// Area of the regular polygon of radius one.
double polygon_area() {
    return 0.5 * kSegments * std::sin(2 * kPiDouble / static_cast<double>(kSegments));
}

TEST(Revolution, a_cylinder_with_poles_is_closed) {
    const Mesh mesh = revolve({{0, 1}, {2, 1}, {2, 4}, {0, 4}}, kSegments);
    EXPECT_EQ(mesh.points.size(), 2 + 2 * kSegments);
    EXPECT_EQ(mesh.triangles.size(), 4 * kSegments);
    EXPECT_TRUE(open_edges(mesh).empty());
    EXPECT_NEAR(volume(mesh), polygon_area() * 4 * 3, 1e-5);
}

TEST(Revolution, a_cone_is_a_pyramid) {
    const Mesh mesh = revolve({{0, 0}, {1, 0}, {0, 3}}, kSegments);
    EXPECT_TRUE(open_edges(mesh).empty());
    EXPECT_NEAR(volume(mesh), polygon_area() * 3 / 3, 1e-6);
}

TEST(Revolution, rings_are_the_same_bits_in_any_mesh) {
    const Mesh tube = revolve({{1, 0}, {1.7, 0.3}}, 136);
    const Mesh lid = fill_ring({1.7, 0.3}, 136);
    const std::vector<std::array<float, 3>> edge(tube.points.end() - 136, tube.points.end());
    EXPECT_EQ(edge, lid.points);
    EXPECT_EQ(lid.points[34][0], 0);  // quarter turns are exact
    EXPECT_EQ(lid.points[68][1], 0);
}

TEST(Revolution, a_filled_ring_covers_its_polygon_facing_up) {
    const Mesh lid = fill_ring({3, 5}, kSegments);
    ASSERT_EQ(lid.triangles.size(), kSegments - 2);
    Vec3d sum(0);
    for (const auto& t : lid.triangles) {
        EXPECT_GT(area_vector(lid, t).z, 0);
        sum += area_vector(lid, t);
    }
    EXPECT_NEAR(sum.z, 9 * polygon_area(), 1e-5);
    EXPECT_EQ(open_edges(lid).size(), kSegments);
}

TEST(Revolution, a_curve_passes_where_de_casteljau_says_and_ends_exactly) {
    Profile profile = {{1, 0}};
    append_bezier(profile, {{{2, 0}, {4, 1}, {0.1, 8}}}, 2);
    ASSERT_EQ(profile.size(), 3);
    EXPECT_DOUBLE_EQ(profile[1].radius, (1 + 3 * 2 + 3 * 4 + 0.1) / 8);
    EXPECT_DOUBLE_EQ(profile[1].height, (0 + 0 + 3 * 1 + 8) / 8.0);
    EXPECT_EQ(profile[2].radius, 0.1);
    EXPECT_EQ(profile[2].height, 8);
}

}  // namespace
}  // namespace sunfleck::engine
