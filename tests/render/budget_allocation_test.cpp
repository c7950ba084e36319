// Camera paths against photon paths: the rule, by hand.
#include "planning/budget_allocation.h"

#include "film/film_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kUsual = 160'000;
constexpr SubpassCost kCost{100'000, 2};

/// Where a pass should be worth a subpass with the usual paths.
PhotonBudget allocated_budget(const SubpassMeasures& subpass, std::uint32_t usual,
                              double fewest = 2) {
    return sunfleck::engine::allocated_budget(subpass, usual, fewest,
                                              error_of_subpass(subpass, usual));
}

std::uint32_t of(std::vector<BlockVariance> blocks, const SubpassCost& cost = kCost) {
    return allocated_budget({std::move(blocks), cost}, kUsual).paths;
}

TEST(BudgetAllocation, few_photons_where_camera_paths_are_all_the_noise) {
    EXPECT_EQ(of({{3, 0}, {0.1, 0}}), kUsual / 16);
}

TEST(BudgetAllocation, many_photons_where_they_are_all_the_noise) {
    EXPECT_EQ(of({{0, 3}, {0, 0.1}}), kUsual * 4);
}

// Least at n = sqrt(photon / camera * cost of camera / cost of photon).
TEST(BudgetAllocation, the_best_number_between) {
    for (const double best : {20'000.0, 40'000.0, 80'000.0, 160'000.0, 320'000.0}) {
        const double photon = best * best * kCost.photon / kCost.camera;
        EXPECT_EQ(of({{1, photon}}), static_cast<std::uint32_t>(best));
        EXPECT_EQ(of({{2.5, 2.5 * photon}, {1e-3, 1e-3 * photon}}),
                  static_cast<std::uint32_t>(best));
        // What each ray costs does not matter, only their ratio.
        EXPECT_EQ(of({{1, photon}}, {7 * kCost.camera, 7 * kCost.photon}),
                  static_cast<std::uint32_t>(best));
    }
}

// With n = u / 4 and E = 3 P / u a subpass has a variance of 7 in place of 4 P / u.
TEST(BudgetAllocation, as_many_subpasses_as_are_worth_a_usual_one) {
    const auto all_of = [](double camera, double fewest, const SubpassCost& cost) {
        return allocated_budget({{{camera, 160'000}}, cost}, kUsual, fewest);
    };
    constexpr SubpassCost kNoCamera{0, 2};
    EXPECT_EQ(all_of(3, kUsual / 4.0, kNoCamera), (PhotonBudget{kUsual / 4, 2}));    // 7 over 4
    EXPECT_EQ(all_of(0.9, kUsual / 4.0, kNoCamera), (PhotonBudget{kUsual / 4, 3}));  // 4.9 over 1.9
    EXPECT_EQ(all_of(0.1, kUsual / 4.0, kNoCamera), (PhotonBudget{kUsual / 4, 4}));  // 4.1 over 1.1
    EXPECT_EQ(all_of(30, kUsual / 4.0, kNoCamera), (PhotonBudget{kUsual / 4, 1}));   // 34 over 31
    EXPECT_EQ(all_of(1e-3, 2, kNoCamera), (PhotonBudget{kUsual / 16, 16}));
    constexpr SubpassCost kNoPhotons{100'000, 0};
    EXPECT_EQ(all_of(1, 2, kNoPhotons),
              (PhotonBudget{kUsual * 4, 1, 2}));  // never less than one subpass
}

// With n = 4 u a subpass has a variance of E + P / 4 u in place of E + P / u.
TEST(BudgetAllocation, better_passes_count_for_as_many_as_they_are_worth) {
    const auto weight = [](double camera, double photon) {
        const PhotonBudget seen =
            allocated_budget({{{camera, photon * kUsual}}, {100'000, 0}}, kUsual);
        EXPECT_EQ(seen.paths, 4 * kUsual);
        EXPECT_EQ(seen.subpasses, 1U);
        return seen.weight;
    };
    EXPECT_EQ(weight(0, 1), 4U);
    EXPECT_EQ(weight(0.2, 1), 3U);  // 1.2 over .45
    EXPECT_EQ(weight(1, 1), 2U);    // 2 over 1.25
    EXPECT_EQ(weight(4, 1), 1U);    // 5 over 4.25
    const SubpassMeasures subpass{{{1, 0}}, kCost};
    EXPECT_EQ(sunfleck::engine::allocated_budget(subpass, kUsual, 2, 100).weight, kMostWeight);
}

// Camera paths make variances of 4 in place of 1 and there are no photons: four subpasses.
TEST(BudgetAllocation, a_pass_may_be_worth_more_than_any_subpass) {
    const SubpassMeasures subpass{{{4, 0}}, kCost};
    EXPECT_EQ(sunfleck::engine::allocated_budget(subpass, kUsual, 2, 1).subpasses, 4U);
    EXPECT_EQ(sunfleck::engine::allocated_budget(subpass, kUsual, kUsual, 0.1),
              (PhotonBudget{kUsual, 16}));
    EXPECT_EQ(sunfleck::engine::allocated_budget(subpass, kUsual, 2, 9).subpasses, 1U);
}

// Of two blocks the roots add up: of 1 + 1 and of 4 + 0.
TEST(BudgetAllocation, the_error_of_subpasses_is_a_mean_of_roots_at_the_same_work) {
    const SubpassMeasures subpass{{{1, kUsual}, {4, 0}}, kCost};
    EXPECT_NEAR(error_of_subpasses(subpass, kUsual),
                (std::sqrt(2) + 2) * std::sqrt(kCost.camera + kCost.photon * kUsual), 1e-6);
    EXPECT_NEAR(error_of_subpasses(subpass, 4 * kUsual),
                (std::sqrt(1.25) + 2) * std::sqrt(kCost.camera + 4 * kCost.photon * kUsual), 1e-6);
}

// In the mean of squares it would: 50 of camera paths, 25 of the usual photons, best at 0.4 of
// them.
TEST(BudgetAllocation, one_wild_block_does_not_speak_for_all) {
    std::vector<BlockVariance> blocks(400, {0, 1e4});
    blocks.push_back({50, 0});
    EXPECT_GE(of(blocks), kUsual * 2);
}

// Measured variances are noisy.
TEST(BudgetAllocation, a_negative_variance_counts_as_none) {
    EXPECT_EQ(of({{-1e-3, 100}}), kUsual * 4);
    EXPECT_EQ(of({{-1, 0}, {1, 0}}), kUsual / 16);
}

TEST(BudgetAllocation, nothing_known_changes_nothing) {
    const PhotonBudget usual{kUsual, 1};
    EXPECT_EQ(allocated_budget({{}, kCost}, kUsual), usual);
    EXPECT_EQ(allocated_budget({{{0, 0}, {0, 0}}, kCost}, kUsual), usual);
    EXPECT_EQ(allocated_budget({{{1, 0}}, kCost}, 16), (PhotonBudget{2, 1}));
}

TEST(BudgetAllocation, keeps_to_the_fewest_that_are_allowed) {
    const auto fewest = [](double paths) {
        return allocated_budget({{{1, 0}}, kCost}, kUsual, paths).paths;
    };
    EXPECT_EQ(fewest(kUsual / 4), kUsual / 4);
    EXPECT_EQ(fewest(kUsual / 4 + 1), kUsual / 2);
    EXPECT_EQ(fewest(kUsual), kUsual);
    EXPECT_EQ(fewest(9.0 * kUsual), kUsual);
}

}  // namespace
}  // namespace sunfleck::engine
