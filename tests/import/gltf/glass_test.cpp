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
    const std::vector<bool> closed = sides_of_primitives({&mesh})[0].is_closed;
    ASSERT_EQ(closed.size(), 22U);
    for (std::size_t i = 0; i < 22; ++i) EXPECT_EQ(closed[i], i < 12) << i;
    EXPECT_EQ(chosen_triangles(mesh, closed).triangles.size(), 12U);
}

TEST(GltfGlass, primitives_may_close_each_other) {
    const TriangleMesh cup = box({0, 0, 0}, {1, 1, 1}, true);
    TriangleMesh lid;
    lid.positions = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    lid.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_FALSE(sides_of_primitives({&cup})[0].is_closed[0]);
    const auto both = sides_of_primitives({&cup, &lid});
    EXPECT_TRUE(both[0].is_closed[0]);
    EXPECT_TRUE(both[1].is_closed[1]);
}

TEST(GltfGlass, triangles_without_area_neither_open_a_surface_nor_are_panes) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.triangles.push_back({0, 0, 1});
    const std::vector<bool> closed = sides_of_primitives({&mesh})[0].is_closed;
    EXPECT_TRUE(closed[0]);
    EXPECT_TRUE(closed[12]);
}

/// Else light would meet glass around air.
TEST(GltfGlass, that_faces_inwards_is_turned_with_its_normals) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.normals.assign(mesh.positions.size(), Vec3(1, 0, 0));
    EXPECT_FALSE(sides_of_primitives({&mesh})[0].is_reversed[0]);
    TriangleMesh inward = mesh;
    turn_triangles(inward, std::vector<bool>(12, true));
    EXPECT_EQ(inward.normals[0], Vec3(-1, 0, 0));
    const std::vector<bool> reversed = sides_of_primitives({&inward})[0].is_reversed;
    EXPECT_EQ(reversed, std::vector<bool>(12, true));
    turn_triangles(inward, reversed);
    EXPECT_EQ(inward.triangles, mesh.triangles);
    EXPECT_EQ(inward.normals, mesh.normals);
}

}  // namespace
}  // namespace sunfleck::engine
