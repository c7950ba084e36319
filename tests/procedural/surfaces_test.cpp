// Rings and balls: closed, oriented, of nearly the volume of the smooth body.

#include "procedural/surfaces.h"

#include "math/trigonometry.h"
#include "mesh_checks.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

TEST(Surfaces, a_torus_is_closed_and_full) {
    const Mesh ring = torus(3, 0.5, 48, 24);
    EXPECT_EQ(ring.triangles.size(), 2 * 48 * 24);
    EXPECT_TRUE(open_edges(ring).empty());
    EXPECT_NEAR(volume(ring), 2 * kPiDouble * 3 * kPiDouble * 0.25, 0.25);
}

TEST(Surfaces, an_ellipsoid_is_closed_and_full) {
    const Mesh ball = superellipsoid({1, 2, 3}, 1, 32, 24);
    EXPECT_EQ(ball.triangles.size(), 2 * 32 * 23);
    EXPECT_TRUE(open_edges(ball).empty());
    EXPECT_NEAR(volume(ball), 8 * kPiDouble, 0.4);
}

TEST(Surfaces, a_small_power_makes_a_box) {
    const Mesh cushion = superellipsoid({1, 2, 3}, 0.1F, 64, 48);
    EXPECT_TRUE(open_edges(cushion).empty());
    EXPECT_GT(volume(cushion), 0.93 * 48);
    EXPECT_LT(volume(cushion), 48);
}

// The chain leaves the plane, so that carrying a direction around it turns it: the seam must close.
TEST(Surfaces, a_tube_closes_around_a_bent_chain) {
    std::vector<Vec3d> chain;
    for (int i = 0; i < 60; ++i) {
        const SinCos t = sin_cos_turn(i / 60.0);
        const SinCos wave = sin_cos_turn(i / 20.0);
        chain.emplace_back(4 * t.cos, 4 * t.sin, wave.sin);
    }
    const Mesh tube = closed_tube(chain, 0.3, 16);
    EXPECT_TRUE(open_edges(tube).empty());
    EXPECT_GT(volume(tube), 0);
    // Without a twist at the seam no edge along the tube is longer than the chain's steps allow.
    for (std::uint32_t i = 0; i < 60; ++i)
        for (std::uint32_t j = 0; j < 16; ++j) {
            const Vec3d step = corner(tube, (i + 1) % 60 * 16 + j) - corner(tube, i * 16 + j);
            ASSERT_LT(step.length(), 0.62);
        }
}

}  // namespace
}  // namespace sunfleck
