// Smooth surfaces of revolution: normals at right angles to the profile, on its right-hand side.

#include "procedural/smooth_revolution.h"

#include "mesh_checks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

/// A quarter of a circle from the lowest point to the widest, to 3e-4 of its radius.
constexpr double kRound = 0.5522847498;
constexpr ProfileCurve kQuarter = {{{0, -1}, {kRound, -1}, {1, -kRound}, {1, 0}}};

TEST(SmoothRevolution, a_turned_circle_has_the_normals_of_a_sphere) {
    SmoothProfile profile;
    append_curve(profile, kQuarter, 16);
    append_curve(profile, {{{1, 0}, {1, kRound}, {kRound, 1}, {0, 1}}}, 16);
    const Mesh ball = revolve_smooth(profile, 32);
    ASSERT_EQ(ball.normals.size(), ball.points.size());
    EXPECT_TRUE(open_edges(ball).empty());
    for (std::size_t i = 0; i < ball.points.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(ball.normals[i].at(axis), ball.points[i].at(axis), 2e-3);
}

TEST(SmoothRevolution, a_reversed_profile_has_its_normals_on_the_other_side) {
    SmoothProfile profile;
    append_curve(profile, kQuarter, 4);
    const Mesh bowl = revolve_smooth(reversed(profile), 8);
    EXPECT_GT(bowl.normals.back().at(2), 0.99);  // the lowest point, seen from inside
    EXPECT_LT(bowl.normals.front().at(0), -0.99);
}

TEST(SmoothRevolution, a_curve_that_was_split_is_still_the_same_curve) {
    SmoothProfile whole;
    append_curve(whole, kQuarter, 8);
    const auto [first, second] = split(kQuarter, 0.25);
    SmoothProfile parts;
    append_curve(parts, first, 2);
    append_curve(parts, second, 6);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_NEAR(parts[i].position.radius, whole[i].position.radius, 1e-12);
        EXPECT_NEAR(parts[i].position.height, whole[i].position.height, 1e-12);
    }
}

}  // namespace
}  // namespace sunfleck::engine
