// Camera paths against photon paths: the rule, by hand.
#include "render/balance_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunfleck {
namespace {

constexpr std::uint32_t kUsual = 160'000;
constexpr PassCost kCost{100'000, 2};

std::uint32_t of(std::vector<BlockVariance> blocks, const PassCost& cost = kCost) {
    return balanced_paths(blocks, cost, kUsual);
}

TEST(BalanceRule, few_photons_where_camera_paths_are_all_the_noise) {
    EXPECT_EQ(of({{3, 0}, {0.1, 0}}), kUsual / 16);
}

TEST(BalanceRule, many_photons_where_they_are_all_the_noise) {
    EXPECT_EQ(of({{0, 3}, {0, 0.1}}), kUsual * 4);
}

// Least at n = sqrt(photon / eye * cost of eye / cost of photon).
TEST(BalanceRule, the_best_number_between) {
    for (const double best : {20'000.0, 40'000.0, 80'000.0, 160'000.0, 320'000.0}) {
        const double photon = best * best * kCost.photon / kCost.eye;
        EXPECT_EQ(of({{1, photon}}), static_cast<std::uint32_t>(best));
        EXPECT_EQ(of({{2.5, 2.5 * photon}, {1e-3, 1e-3 * photon}}),
                  static_cast<std::uint32_t>(best));
        // What each ray costs does not matter, only their ratio.
        EXPECT_EQ(of({{1, photon}}, {7 * kCost.eye, 7 * kCost.photon}),
                  static_cast<std::uint32_t>(best));
    }
}

// Least is ((1 + b) E + b P / u + P / n) ((1 + b) c + b p u + p n), of n among powers of two.
TEST(BalanceRule, passes_before_draw_it_towards_their_own) {
    const auto after = [](double before, double eye, double photon) {
        return balanced_paths(std::vector<BlockVariance>{{eye, photon}}, kCost, kUsual, 2, before);
    };
    const auto best_after = [](double before, double eye, double photon) {
        const double work = (1 + before) * kCost.eye + before * kCost.photon * kUsual;
        const double rest = (1 + before) * eye + before * photon / kUsual;
        return std::sqrt(photon * work / (kCost.photon * rest));
    };
    for (const double eye : {1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1.0})
        for (const double before : {0.0, 0.25, 1.0, 4.0}) {
            const double best = std::clamp(best_after(before, eye, 1), kUsual / 16.0, kUsual * 4.0);
            const double ratio = after(before, eye, 1) / best;
            EXPECT_GT(ratio, 0.7) << eye << ' ' << before;
            EXPECT_LT(ratio, 1.42) << eye << ' ' << before;
        }
    EXPECT_EQ(after(0, 1, 0), kUsual / 16);
    EXPECT_EQ(after(1, 1, 0), kUsual / 16);  // photons bring nothing at all
}

// In the mean of squares it would: 50 of camera paths, 25 of the usual photons, best at 0.4 of
// them.
TEST(BalanceRule, one_wild_block_does_not_speak_for_all) {
    std::vector<BlockVariance> blocks(400, {0, 1e4});
    blocks.push_back({50, 0});
    EXPECT_GE(of(blocks), kUsual * 2);
}

// Measured variances are noisy.
TEST(BalanceRule, a_negative_variance_counts_as_none) {
    EXPECT_EQ(of({{-1e-3, 100}}), kUsual * 4);
    EXPECT_EQ(of({{-1, 0}, {1, 0}}), kUsual / 16);
}

TEST(BalanceRule, nothing_known_changes_nothing) {
    EXPECT_EQ(of({}), kUsual);
    EXPECT_EQ(of({{0, 0}, {0, 0}}), kUsual);
    EXPECT_EQ(balanced_paths(std::vector<BlockVariance>{{1, 0}}, kCost, 16), 2U);
}

TEST(BalanceRule, keeps_to_the_fewest_that_are_allowed) {
    const std::vector<BlockVariance> no_photons{{1, 0}};
    EXPECT_EQ(balanced_paths(no_photons, kCost, kUsual, kUsual / 4), kUsual / 4);
    EXPECT_EQ(balanced_paths(no_photons, kCost, kUsual, kUsual / 4 + 1), kUsual / 2);
    EXPECT_EQ(balanced_paths(no_photons, kCost, kUsual, kUsual), kUsual);
    EXPECT_EQ(balanced_paths(no_photons, kCost, kUsual, 9.0 * kUsual), kUsual);
}

}  // namespace
}  // namespace sunfleck
