// Placements: quarter turns are exact, an inner placement is carried by the outer one.

#include "procedural/placement.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Placement, quarter_turns_are_exact) {
    EXPECT_EQ(turned(0.25, Vec3d(0))({1, 0, 0}), Vec3d(0, 1, 0));
    EXPECT_EQ(tilted(0.25, Vec3d(0))({0, 1, 0}), Vec3d(0, 0, 1));
    EXPECT_EQ(standing(0, {5, 6, 7})({1, 2, 3}), Vec3d(6, 3, 9));
}

TEST(Placement, the_outer_one_carries_the_inner_one) {
    const Placement outer = turned(0.1, {1, 2, 3});
    const Placement inner = tilted(0.3, {4, 5, 6});
    const Vec3d p(0.5, -2, 1);
    const Vec3d once = (outer * inner)(p);
    const Vec3d twice = outer(inner(p));
    EXPECT_NEAR((once - twice).length(), 0, 1e-14);
    EXPECT_NEAR((outer * inner).x.cross((outer * inner).y).dot((outer * inner).z), 1, 1e-14);
}

TEST(Placement, normals_turn_and_do_not_move) {
    Mesh mesh;
    mesh.points = {{1, 0, 0}};
    mesh.normals = {{1, 0, 0}};
    const Mesh moved = placed(mesh, turned(0.25, {0, 0, 9}));
    EXPECT_EQ(moved.points[0], (std::array<float, 3>{0, 1, 9}));
    EXPECT_EQ(moved.normals[0], (std::array<float, 3>{0, 1, 0}));
}

}  // namespace
}  // namespace sunfleck::engine
