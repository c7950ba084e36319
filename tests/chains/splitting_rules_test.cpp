// The rules of ladders: when there is one, how many sets, which heights, which budgets.
#include "chains/splitting_rules.h"

#include <gtest/gtest.h>

namespace sunfleck {
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

std::vector<int> heights_of(const LadderPlan& plan) {
    std::vector<int> heights;
    for (const LevelPlan& level : plan.levels) heights.push_back(level.height);
    return heights;
}

/// What every ladder keeps.
void expect_sound(const LadderPlan& plan, std::uint32_t paths) {
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

TEST(LadderRules, uniform_paths_alone_from_a_twentieth) {
    const LadderPlan plan = ladder_plan(even_tail(0.05), kPaths);
    EXPECT_EQ(plan, (LadderPlan{kPaths, {}}));
    EXPECT_EQ(ladder_plan(even_tail(0.7), kPaths).levels.size(), 0U);
    EXPECT_EQ(ladder_plan(even_tail(0.0499), kPaths).levels.size(), 1U);
}

TEST(LadderRules, one_set_where_64_seeds_are_expected) {
    const LadderPlan one = ladder_plan(even_tail(64.1 / (kPaths / 2)), kPaths);
    expect_sound(one, kPaths);
    EXPECT_EQ(heights_of(one), std::vector<int>{kVisible});
    EXPECT_EQ(one.uniform_paths, kPaths / 2);
    EXPECT_EQ(one.levels[0].states, kPaths / 2);
    EXPECT_GE(one.levels[0].chains, 256U);
    EXPECT_GT(ladder_plan(even_tail(63.9 / (kPaths / 2)), kPaths).levels.size(), 1U);
}

TEST(LadderRules, sets_are_as_many_as_steps_of_a_twentieth) {
    for (const auto& [visible, sets] : {std::pair{1.3e-4, 3},
                                        {1.2e-4, 4},
                                        {1e-5, 4},
                                        {1e-6, 5},
                                        {1e-7, 6},
                                        {1e-8, 7},
                                        {1e-9, 7}}) {
        const LadderPlan plan = ladder_plan(even_tail(visible), kPaths);
        expect_sound(plan, kPaths);
        ASSERT_EQ(plan.levels.size(), static_cast<std::size_t>(sets)) << visible;
        for (int k = 1; k <= sets; ++k)
            EXPECT_NEAR(plan.levels.at(static_cast<std::size_t>(k - 1)).height,
                        static_cast<double>(kVisible) * k / sets, 0.51);
    }
}

TEST(LadderRules, one_set_where_no_ladder_is_wanted) {
    for (const double visible : {0.7, 0.04, 1e-3, 1e-6, 0.0}) {
        HeightTail tail = even_tail(std::max(visible, 1e-6));
        tail[kVisible] = visible;
        const LadderPlan plan = ladder_plan(tail, kPaths, Sets::one);
        expect_sound(plan, kPaths);
        EXPECT_EQ(plan.levels.size(), visible < 0.05 ? 1U : 0U) << visible;
        EXPECT_EQ(plan.levels.empty() ? 0 : plan.levels[0].states, visible < 0.05 ? kPaths / 2 : 0);
    }
}

TEST(LadderRules, half_to_the_last_set_and_the_rest_in_equal_shares) {
    const LadderPlan plan = ladder_plan(even_tail(1e-6), kPaths);
    EXPECT_EQ(plan.levels.back().states, kPaths / 2);
    for (std::size_t k = 0; k + 1 < plan.levels.size(); ++k)
        EXPECT_EQ(plan.levels[k].states, kPaths / 10);
    EXPECT_NEAR(plan.uniform_paths, kPaths / 10, 10);
}

TEST(LadderRules, few_long_chains) {
    const LadderPlan plan = ladder_plan(even_tail(1e-6), 2'000'000);
    for (std::size_t k = 0; k + 1 < plan.levels.size(); ++k) EXPECT_EQ(plan.levels[k].chains, 256U);
    EXPECT_EQ(plan.levels.back().chains, 1024U);
    for (const LevelPlan& level : ladder_plan(even_tail(1e-6), 20'000).levels)
        EXPECT_GE(level.states / level.chains, 64U);
}

TEST(LadderRules, nearly_equal_neighbours_are_left_out) {
    // from 0.9 the tail stands still for long, then falls at once to what is hardly more than b
    const HeightTail tail = tail_from(20, {0.9, 0.9, 0.9, 0.9, 1.2e-6, 1.2e-6, 1e-6});
    EXPECT_EQ(heights_of(ladder_plan(tail, kPaths)), std::vector<int>{kVisible});
    const HeightTail two = tail_from(20, {1e-3, 0.9e-3, 0.8e-3, 0.8e-3, 0.8e-3, 0.8e-3, 1e-6});
    EXPECT_EQ(heights_of(ladder_plan(two, kPaths)).size(), 2U);
    expect_sound(ladder_plan(two, kPaths), kPaths);
}

TEST(LadderRules, no_visible_path_found_climbs_what_was_reached) {
    const HeightTail tail = tail_from(15, {0.1, 0.09, 0.01, 0.001});
    const LadderPlan plan = ladder_plan(tail, kPaths);
    expect_sound(plan, kPaths);
    EXPECT_EQ(heights_of(plan), (std::vector<int>{15, 17, 18, kVisible}));
    const LadderPlan nothing = ladder_plan(HeightTail{1}, kPaths);
    expect_sound(nothing, kPaths);
    EXPECT_EQ(heights_of(nothing), std::vector<int>{kVisible});
}

TEST(LadderRules, budgets_are_kept_however_small) {
    for (const double visible : {0.0, 1e-12, 1e-6, 1e-3, 0.04, 0.06})
        for (std::uint32_t paths = 2; paths < 300; ++paths) {
            HeightTail tail = visible > 0 ? even_tail(visible) : even_tail(1e-9);
            tail[kVisible] = visible;
            expect_sound(ladder_plan(tail, paths), paths);
        }
    for (const std::uint32_t paths : {999'999U, 1'000'000U, 1'000'003U, 4'000'000'000U})
        expect_sound(ladder_plan(even_tail(1e-7), paths), paths);
}

LearnedMap learned(Covering covering, double visible_share, double rest) {
    LearnedMap map;
    map.rest = rest;
    map.covering = covering;
    map.visible_share = visible_share;
    return map;
}

// Chains are on the map's side for a tenth of the time, or a quarter, if they bring nothing there.
TEST(LadderRules, paths_through_a_map_bring_what_it_covers) {
    const LearnedMap good = learned(Covering::often_visible, 0.7, 0.02);
    const SharedPlan plan = shared_plan(even_tail(1e-5), good, kPaths);
    EXPECT_EQ(plan.mapped.paths, kPaths * 35 / 100);
    EXPECT_EQ(plan.mapped.own_share, 1);
    EXPECT_NEAR(plan.mapped.importance * 0.98 / 0.02, 1 / 9.0, 1e-9);
    expect_sound(plan.ladder, kPaths * 65 / 100);
    EXPECT_EQ(plan.ladder.levels.size(), ladder_plan(even_tail(2e-7), kPaths).levels.size());
    const SharedPlan one = shared_plan(even_tail(1e-5), good, kPaths, Sets::one);
    EXPECT_EQ(one.ladder.levels.size(), 1U);
    EXPECT_EQ(one.mapped.paths, plan.mapped.paths);
    EXPECT_NEAR(plan.ladder.levels.back().states, 0.3 * 0.65 * kPaths, 1);
    const MappedPlan alone =
        shared_plan(tail_from(15, {0.1}), learned(Covering::all_known, 0.02, 0.01), kPaths).mapped;
    EXPECT_EQ(alone.paths, kPaths * 3 / 4);
    EXPECT_EQ(alone.own_share, 1);
    EXPECT_NEAR(alone.importance * 0.99 / 0.01, 1 / 3.0, 1e-9);
    EXPECT_EQ(shared_plan(even_tail(1e-5), learned(Covering::often_visible, 0.7, 0.99), kPaths)
                  .mapped.importance,
              0.5);
}

TEST(LadderRules, chains_bring_what_a_map_hits_seldom) {
    const SharedPlan plan =
        shared_plan(even_tail(1e-5), learned(Covering::often_visible, 0.19, 0.02), kPaths);
    EXPECT_EQ(plan.mapped.paths, kPaths / 10);
    EXPECT_LT(plan.mapped.own_share, 0.5);
    EXPECT_EQ(plan.mapped.importance, 1);
    expect_sound(plan.ladder, kPaths - kPaths / 10);
    EXPECT_NEAR(plan.ladder.levels.back().states, 0.75 * 0.9 * kPaths, 1);
}

TEST(LadderRules, budgets_beside_a_map_are_kept_however_small) {
    for (const double visible_share : {0.1, 0.5})
        for (const Covering covering : {Covering::often_visible, Covering::all_known})
            for (std::uint32_t paths = 2; paths < 100; ++paths) {
                const SharedPlan plan =
                    shared_plan(even_tail(1e-6), learned(covering, visible_share, 0.1), paths);
                expect_sound(plan.ladder, paths - plan.mapped.paths);
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
}  // namespace sunfleck
