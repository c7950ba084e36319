// The rules of splittings: when there is one, how many sets, which heights, which budgets.
#include "chains/splitting_rules.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kPaths = 200'000;

/// Falls evenly, height by height, to `visible`.
HeightTail even_tail(double visible) {
    HeightTail tail{};
    for (std::size_t h = 0; h < tail.size(); ++h)
        tail.at(h) = std::pow(visible, static_cast<double>(h) / kVisible);
    tail[kVisible] = visible;
    return tail;
}

/// 1 up to a height, then what is given; zero beyond.
HeightTail tail_from(int height, const std::vector<double>& rest) {
    HeightTail tail{};
    for (int h = 0; h < height; ++h) tail.at(static_cast<std::size_t>(h)) = 1;
    for (std::size_t i = 0; i < rest.size(); ++i)
        tail.at(static_cast<std::size_t>(height) + i) = rest[i];
    return tail;
}

std::vector<int> heights_of(const SplittingPlan& plan) {
    std::vector<int> heights;
    for (const LevelPlan& level : plan.levels) heights.push_back(level.height);
    return heights;
}

/// What every splitting keeps.
void expect_sound(const SplittingPlan& plan, std::uint32_t paths) {
    EXPECT_EQ(plan.paths(), paths);
    EXPECT_GE(plan.uniform_paths, 1U);
    int last = 0;
    for (const LevelPlan& level : plan.levels) {
        EXPECT_GT(level.height, last);
        last = level.height;
        EXPECT_GE(level.chains, 1U);
        EXPECT_GE(level.states, level.chains);
    }
    EXPECT_EQ(last, plan.levels.empty() ? 0 : kVisible);
}

TEST(SplittingRules, uniform_paths_alone_from_a_twentieth) {
    const SplittingPlan plan = splitting_plan(even_tail(0.05), kPaths);
    EXPECT_EQ(plan, (SplittingPlan{kPaths, {}}));
    EXPECT_EQ(splitting_plan(even_tail(0.7), kPaths).levels.size(), 0U);
    EXPECT_EQ(splitting_plan(even_tail(0.0499), kPaths).levels.size(), 1U);
}

TEST(SplittingRules, one_set_where_64_seeds_are_expected) {
    const SplittingPlan one = splitting_plan(even_tail(64.1 / (kPaths / 2)), kPaths);
    expect_sound(one, kPaths);
    EXPECT_EQ(heights_of(one), std::vector<int>{kVisible});
    EXPECT_EQ(one.uniform_paths, kPaths / 2);
    EXPECT_EQ(one.levels[0].states, kPaths / 2);
    EXPECT_GE(one.levels[0].chains, 256U);
    EXPECT_GT(splitting_plan(even_tail(63.9 / (kPaths / 2)), kPaths).levels.size(), 1U);
}

TEST(SplittingRules, sets_are_as_many_as_steps_of_a_twentieth) {
    for (const auto& [visible, sets] : {std::pair{1.3e-4, 3},
                                        {1.2e-4, 4},
                                        {1e-5, 4},
                                        {1e-6, 5},
                                        {1e-7, 6},
                                        {1e-8, 7},
                                        {1e-9, 7}}) {
        const SplittingPlan plan = splitting_plan(even_tail(visible), kPaths);
        expect_sound(plan, kPaths);
        ASSERT_EQ(plan.levels.size(), static_cast<std::size_t>(sets)) << visible;
        for (int k = 1; k <= sets; ++k)
            EXPECT_NEAR(plan.levels.at(static_cast<std::size_t>(k - 1)).height,
                        static_cast<double>(kVisible) * k / sets, 0.51);
    }
}

TEST(SplittingRules, one_set_where_no_splitting_is_wanted) {
    for (const double visible : {0.7, 0.04, 1e-3, 1e-6, 0.0}) {
        HeightTail tail = even_tail(std::max(visible, 1e-6));
        tail[kVisible] = visible;
        const SplittingPlan plan = splitting_plan(tail, kPaths, Sets::one);
        expect_sound(plan, kPaths);
        EXPECT_EQ(plan.levels.size(), visible < 0.05 ? 1U : 0U) << visible;
        EXPECT_EQ(plan.levels.empty() ? 0 : plan.levels[0].states, visible < 0.05 ? kPaths / 2 : 0);
    }
}

TEST(SplittingRules, half_to_the_last_set_and_the_rest_in_equal_shares) {
    const SplittingPlan plan = splitting_plan(even_tail(1e-6), kPaths);
    EXPECT_EQ(plan.levels.back().states, kPaths / 2);
    for (std::size_t k = 0; k + 1 < plan.levels.size(); ++k)
        EXPECT_EQ(plan.levels[k].states, kPaths / 10);
    EXPECT_NEAR(plan.uniform_paths, kPaths / 10, 10);
}

TEST(SplittingRules, few_long_chains) {
    const SplittingPlan plan = splitting_plan(even_tail(1e-6), 2'000'000);
    for (std::size_t k = 0; k + 1 < plan.levels.size(); ++k) EXPECT_EQ(plan.levels[k].chains, 256U);
    EXPECT_EQ(plan.levels.back().chains, 1024U);
    for (const LevelPlan& level : splitting_plan(even_tail(1e-6), 20'000).levels)
        EXPECT_GE(level.states / level.chains, 64U);
}

TEST(SplittingRules, nearly_equal_neighbours_are_left_out) {
    // from 0.9 the tail stands still for long, then falls at once to what is hardly more than b
    const HeightTail tail = tail_from(20, {0.9, 0.9, 0.9, 0.9, 1.2e-6, 1.2e-6, 1e-6});
    EXPECT_EQ(heights_of(splitting_plan(tail, kPaths)), std::vector<int>{kVisible});
    const HeightTail two = tail_from(20, {1e-3, 0.9e-3, 0.8e-3, 0.8e-3, 0.8e-3, 0.8e-3, 1e-6});
    EXPECT_EQ(heights_of(splitting_plan(two, kPaths)).size(), 2U);
    expect_sound(splitting_plan(two, kPaths), kPaths);
}

TEST(SplittingRules, no_visible_path_found_climbs_what_was_reached) {
    const HeightTail tail = tail_from(15, {0.1, 0.09, 0.01, 0.001});
    const SplittingPlan plan = splitting_plan(tail, kPaths);
    expect_sound(plan, kPaths);
    EXPECT_EQ(heights_of(plan), (std::vector<int>{15, 17, 18, kVisible}));
    const SplittingPlan nothing = splitting_plan(HeightTail{1}, kPaths);
    expect_sound(nothing, kPaths);
    EXPECT_EQ(heights_of(nothing), std::vector<int>{kVisible});
}

TEST(SplittingRules, budgets_are_kept_however_small) {
    for (const double visible : {0.0, 1e-12, 1e-6, 1e-3, 0.04, 0.06})
        for (std::uint32_t paths = 2; paths < 300; ++paths) {
            HeightTail tail = visible > 0 ? even_tail(visible) : even_tail(1e-9);
            tail[kVisible] = visible;
            expect_sound(splitting_plan(tail, paths), paths);
        }
    for (const std::uint32_t paths : {999'999U, 1'000'000U, 1'000'003U, 4'000'000'000U})
        expect_sound(splitting_plan(even_tail(1e-7), paths), paths);
}

LearnedGuide learned(GuideCoverage covering, double visible_share, double rest) {
    LearnedGuide map;
    map.rest = rest;
    map.covering = covering;
    map.visible_share = visible_share;
    return map;
}

// Chains are on the guide's side for a tenth of the time, or a quarter, if they bring nothing
// there.
TEST(SplittingRules, guided_paths_bring_what_lies_in_the_region) {
    const LearnedGuide good = learned(GuideCoverage::often_visible, 0.7, 0.02);
    const SharedPlan plan = shared_plan(even_tail(1e-5), good, kPaths);
    EXPECT_EQ(plan.guided.paths, kPaths * 35 / 100);
    EXPECT_EQ(plan.guided.own_share, 1);
    EXPECT_NEAR(plan.guided.importance * 0.98 / 0.02, 1 / 9.0, 1e-9);
    expect_sound(plan.splitting, kPaths * 65 / 100);
    EXPECT_EQ(plan.splitting.levels.size(), splitting_plan(even_tail(2e-7), kPaths).levels.size());
    const SharedPlan one = shared_plan(even_tail(1e-5), good, kPaths, Sets::one);
    EXPECT_EQ(one.splitting.levels.size(), 1U);
    EXPECT_EQ(one.guided.paths, plan.guided.paths);
    EXPECT_NEAR(plan.splitting.levels.back().states, 0.3 * 0.65 * kPaths, 1);
    const GuidedPlan alone =
        shared_plan(tail_from(15, {0.1}), learned(GuideCoverage::all_known, 0.02, 0.01), kPaths)
            .guided;
    EXPECT_EQ(alone.paths, kPaths * 3 / 4);
    EXPECT_EQ(alone.own_share, 1);
    EXPECT_NEAR(alone.importance * 0.99 / 0.01, 1 / 3.0, 1e-9);
    EXPECT_EQ(shared_plan(even_tail(1e-5), learned(GuideCoverage::often_visible, 0.7, 0.99), kPaths)
                  .guided.importance,
              0.5);
}

TEST(SplittingRules, chains_bring_what_a_map_hits_seldom) {
    const SharedPlan plan =
        shared_plan(even_tail(1e-5), learned(GuideCoverage::often_visible, 0.19, 0.02), kPaths);
    EXPECT_EQ(plan.guided.paths, kPaths / 10);
    EXPECT_LT(plan.guided.own_share, 0.5);
    EXPECT_EQ(plan.guided.importance, 1);
    expect_sound(plan.splitting, kPaths - kPaths / 10);
    EXPECT_NEAR(plan.splitting.levels.back().states, 0.75 * 0.9 * kPaths, 1);
}

TEST(SplittingRules, budgets_beside_a_guide_are_kept_however_small) {
    for (const double visible_share : {0.1, 0.5})
        for (const GuideCoverage covering :
             {GuideCoverage::often_visible, GuideCoverage::all_known})
            for (std::uint32_t paths = 2; paths < 100; ++paths) {
                const SharedPlan plan =
                    shared_plan(even_tail(1e-6), learned(covering, visible_share, 0.1), paths);
                expect_sound(plan.splitting, paths - plan.guided.paths);
            }
}

TEST(NextHeight, the_greatest_that_a_fiftieth_reaches) {
    HeightCounts heights{};
    heights[3] = 900;
    heights[7] = 80;
    heights[9] = 15;
    heights[12] = 5;
    EXPECT_EQ(next_height(heights, 3), 9);  // 20 of 1000
    heights[3] = 901;
    EXPECT_EQ(next_height(heights, 3), 7);
}

TEST(NextHeight, else_the_lowest_that_any_state_has) {
    HeightCounts heights{};
    heights[3] = 100'000;
    EXPECT_EQ(next_height(heights, 3), kHeights);
    heights[20] = 1;
    heights[22] = 1;
    EXPECT_EQ(next_height(heights, 3), 20);
    EXPECT_EQ(next_height(heights, 22), kHeights);
}

}  // namespace
}  // namespace sunfleck::engine
