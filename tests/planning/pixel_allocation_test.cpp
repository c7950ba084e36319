// The error by which allocations of camera paths are chosen, and what is left of a plan in trials.
#include "planning/pixel_allocation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr double kPaths = 160'000;

TEST(PixelAllocation, error_is_a_sum_of_roots_at_the_same_work) {
    const std::vector<BlockVariance> blocks = {{1, kPaths}, {4, 0}};
    EXPECT_NEAR(error_of_pass(blocks, kPaths, 9), (std::sqrt(2) + 2) * 3, 1e-12);
    EXPECT_NEAR(error_of_pass(blocks, 4 * kPaths, 9), (std::sqrt(1.25) + 2) * 3, 1e-12);
}

// One block of a hundred times the error of the others has half of their sum of errors, and 25
// times their sum of variances.
TEST(PixelAllocation, one_wild_block_does_not_speak_for_all) {
    std::vector<BlockVariance> blocks(400, {1, 0});
    const double calm = error_of_pass(blocks, kPaths, 1);
    blocks.push_back({1e4, 0});
    EXPECT_NEAR(error_of_pass(blocks, kPaths, 1) / calm, 1.25, 1e-12);
}

// Measured variances are noisy.
TEST(PixelAllocation, a_negative_variance_counts_as_none) {
    EXPECT_NEAR(error_of_pass({{-1, kPaths}}, kPaths, 1), 1, 1e-12);
    EXPECT_NEAR(error_of_pass({{1, -kPaths}}, kPaths, 1), 1, 1e-12);
}

TEST(PixelAllocation, trials_take_a_part_of_all_that_a_plan_has) {
    LightStratum stratum{};
    stratum.plan = {1000, {{3, 400, 40, {}}, {kVisible, 800, 2, {}}}};
    const std::vector<LightStratum> parts = fraction_of({stratum, stratum}, 4);
    ASSERT_EQ(parts.size(), 2U);
    const SplittingPlan expected{250, {{3, 100, 10, {}}, {kVisible, 200, 1, {}}}};
    EXPECT_EQ(parts.front().plan, expected);
    EXPECT_EQ(parts.front().guided.paths, 0U);  // no map: none through it
    EXPECT_EQ(paths_of(parts), 2 * 550U);
}

}  // namespace
}  // namespace sunfleck::engine
