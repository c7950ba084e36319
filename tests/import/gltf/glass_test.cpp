// Which glass is solid: closed components, and straight ways through them.
#include "import/gltf/glass.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// A box whose corners are one vertex for each of its faces, as exporters write it.
TriangleMesh box(const Vec3& low, const Vec3& high, bool is_open = false) {
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool is_high : {false, true}) {
            if (is_open && axis == 2 && is_high) continue;
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                Vec3 p;
                p[axis] = is_high ? high[axis] : low[axis];
                p[(axis + 1) % 3] = u ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
                p[(axis + 2) % 3] = v ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
                mesh.positions.push_back(p);
            }
            if (is_high) {
                mesh.triangles.push_back({first, first + 1, first + 2});
                mesh.triangles.push_back({first, first + 2, first + 3});
            } else {
                mesh.triangles.push_back({first + 2, first + 1, first});
                mesh.triangles.push_back({first + 3, first + 2, first});
            }
        }
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& t : other.triangles)
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

TEST(GltfGlass, a_component_is_closed_where_two_triangles_share_each_edge) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    append(mesh, box({2, 0, 0}, {3, 1, 1}, true));
    const auto closed = closed_triangles({&mesh});
    ASSERT_EQ(closed[0].size(), 22U);
    for (std::size_t i = 0; i < 22; ++i) EXPECT_EQ(closed[0][i], i < 12) << i;
    EXPECT_EQ(chosen_triangles(mesh, closed[0]).triangles.size(), 12U);
}

TEST(GltfGlass, primitives_may_close_each_other) {
    const TriangleMesh cup = box({0, 0, 0}, {1, 1, 1}, true);
    TriangleMesh lid;
    lid.positions = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    lid.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_FALSE(closed_triangles({&cup})[0][0]);
    const auto both = closed_triangles({&cup, &lid});
    EXPECT_TRUE(both[0][0]);
    EXPECT_TRUE(both[1][1]);
}

TEST(GltfGlass, triangles_without_area_do_not_open_a_surface) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.triangles.push_back({0, 0, 1});
    const auto closed = closed_triangles({&mesh});
    EXPECT_TRUE(closed[0][0]);
    EXPECT_FALSE(closed[0][12]);
}

/// Four times the volume over the area.
TEST(GltfGlass, straight_ways_have_cauchys_mean_length) {
    EXPECT_NEAR(mean_chord(box({0, 0, 0}, {1, 1, 1})), 2.0 / 3, 1e-6);
    EXPECT_NEAR(mean_chord(box({5, 5, 5}, {7, 8, 9})), 4 * 24.0 / (2 * (6 + 8 + 12)), 1e-5);
    EXPECT_EQ(mean_chord({}), 0);
}

}  // namespace
}  // namespace sunfleck::engine
