// Which lights share a stratum, and how many paths each stratum gets.
#include "photon/stratum_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace sunfleck::engine {
namespace {

using Groups = std::vector<std::vector<std::size_t>>;

/// Lights of these powers and of these counts in 4000 paths.
std::vector<MeasuredLight> lights(const std::vector<std::pair<double, std::uint64_t>>& rows) {
    std::vector<MeasuredLight> lights;
    lights.reserve(rows.size());
    for (const auto& [power, visible] : rows) lights.push_back({power, 4000, visible});
    return lights;
}

TEST(StratumRules, lights_as_visible_as_each_other_stay_together) {
    EXPECT_EQ(stratified(lights({{1, 300}, {5, 10}, {1, 299}})), (Groups{{0, 1, 2}}));
    EXPECT_EQ(stratified(lights({{1, 3000}})), (Groups{{0}}));
    EXPECT_EQ(stratified(lights({{1, 0}, {100, 0}})), (Groups{{0, 1}}));
}

TEST(StratumRules, a_factor_of_thirty_parts_them) {
    EXPECT_EQ(stratified(lights({{1, 300}, {5, 9}, {1, 299}})), (Groups{{0, 2}, {1}}));
    // Counted from the most visible of a stratum, not from neighbour to neighbour.
    EXPECT_EQ(stratified(lights({{1, 100}, {1, 4}, {1, 3}, {1, 10}})), (Groups{{0, 1, 3}, {2}}));
    // One that was not seen counts as less than one path.
    EXPECT_EQ(stratified(lights({{100, 0}, {1, 30}})), (Groups{{0, 1}}));
    EXPECT_EQ(stratified(lights({{100, 0}, {1, 31}})), (Groups{{1}, {0}}));
}

TEST(StratumRules, a_weak_light_is_in_nobodys_way) {
    EXPECT_EQ(stratified(lights({{1, 1000}, {0.09, 0}})), (Groups{{0, 1}}));
    EXPECT_EQ(stratified(lights({{1, 1000}, {0.11, 0}})), (Groups{{0}, {1}}));
    // It stays with the lights above it, and its power counts there.
    EXPECT_EQ(stratified(lights({{1, 3000}, {0.09, 50}, {0.105, 0}})), (Groups{{0, 1, 2}}));
}

TEST(StratumRules, what_hardly_lights_the_view_gets_no_stratum) {
    EXPECT_EQ(stratified(lights({{1e-4, 4000}, {1, 100}})), (Groups{{0, 1}}));
    EXPECT_EQ(stratified(lights({{1e-3, 4000}, {1, 100}})), (Groups{{0}, {1}}));
    // Of one that was not seen nothing is known.
    EXPECT_EQ(stratified(lights({{1e-4, 4000}, {1, 0}})), (Groups{{0}, {1}}));
}

TEST(StratumRules, there_are_four_strata_at_most) {
    std::vector<MeasuredLight> six;
    std::uint64_t visible = 1'000'000'000;
    for (int i = 0; i < 6; ++i, visible /= 40)
        six.push_back({std::pow(40.0, i), 1U << 30U, visible});
    EXPECT_EQ(stratified(six), (Groups{{0}, {1}, {2}, {3, 4, 5}}));
}

std::uint32_t sum(const std::vector<std::uint32_t>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0U);
}

TEST(StratumRules, paths_go_by_visible_flux_over_visible_paths) {
    // 2 / 0.5 of the flux by a splitting of which half is visible: .02 and .06.
    const auto splittings = shared_paths({{1, 0.01, true}, {3, 0.01, true}}, 100'000);
    EXPECT_EQ(sum(splittings), 100'000U);
    EXPECT_NEAR(splittings[0], 25'000, 5);
    // Uniform paths: as their powers, whatever is visible of them.
    const auto uniform = shared_paths({{1, 0.9, false}, {1, 0.1, false}}, 100'000);
    EXPECT_NEAR(uniform[0], 50'000, 5);
    // A power of 1 uniform, 100 times 1e-3 / .5 by a splitting: 1 to .2.
    const auto mixed = shared_paths({{1, 0.9, false}, {100, 1e-3, true}}, 120'000);
    EXPECT_NEAR(mixed[0], 100'000, 5);
}

TEST(StratumRules, no_group_gets_less_than_a_tenth_of_what_all_need) {
    const auto one = shared_paths({{1, 0.5, false}, {1000, 0, true}}, 110'000);
    EXPECT_EQ(sum(one), 110'000U);
    EXPECT_NEAR(one[1], 10'000, 5);
    const auto two = shared_paths({{1, 0.5, false}, {1, 0, true}, {1, 0, true}}, 120'000);
    EXPECT_NEAR(two[1], 10'000, 5);
    EXPECT_NEAR(two[2], 10'000, 5);
    const auto none = shared_paths({{1, 0, true}, {1, 0, true}}, 1001);
    EXPECT_NEAR(none[0], 500, 2);
    EXPECT_EQ(sum(none), 1001U);
}

TEST(StratumRules, every_group_gets_two_paths_at_least) {
    EXPECT_EQ(shared_paths({{1, 1, false}, {1, 0, true}}, 4), (std::vector<std::uint32_t>{2, 2}));
    const auto few = shared_paths({{1, 1, false}, {1, 0, true}}, 7);
    EXPECT_EQ(few, (std::vector<std::uint32_t>{5, 2}));
}

}  // namespace
}  // namespace sunfleck::engine
