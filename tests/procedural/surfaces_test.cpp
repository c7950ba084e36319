// Rings and balls: closed, oriented, of nearly the volume of the smooth body.

#include "procedural/surfaces.h"

#include "math/trigonometry.h"
#include "mesh_checks.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
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

// Carrying a direction around a knotted chain turns it: the seam must close all the same.
TEST(Surfaces, a_tube_closes_around_a_knotted_chain) {
    constexpr std::uint32_t kSteps = 200;
    std::vector<Vec3d> chain;
    for (std::uint32_t i = 0; i < kSteps; ++i) {
        const SinCos two = sin_cos_2pi(2.0 * i / kSteps);
        const SinCos three = sin_cos_2pi(3.0 * i / kSteps);
        const double r = 3 + three.cos;
        chain.emplace_back(r * two.cos, r * two.sin, three.sin);
    }
    const Mesh tube = closed_tube(chain, 0.4, 16);
    EXPECT_TRUE(open_edges(tube).empty());
    EXPECT_GT(volume(tube), 0);
    // The chain's steps are at most 0.27 long; a tube that is twisted by an eighth of a turn in one
    // step moves its points by 0.3 more.
    for (std::uint32_t i = 0; i < kSteps; ++i)
        for (std::uint32_t j = 0; j < 16; ++j) {
            const std::uint32_t next = (i + 1) % kSteps;
            const Vec3d step =
                corner(tube, next * 16 + j) - corner(tube, i * 16 + j) - (chain[next] - chain[i]);
            ASSERT_LT(step.length(), 0.1) << i;
        }
}

}  // namespace
}  // namespace sunfleck::engine
