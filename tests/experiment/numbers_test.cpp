// Intervals and ranks, against numbers from textbooks and against their own definition.
#include "experiment/numbers.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(StudentT, is_that_of_tables) {
    EXPECT_NEAR(student_t(1), 12.7062, 1e-3);
    EXPECT_NEAR(student_t(30), 2.0423, 1e-3);
    EXPECT_NEAR(student_t(31), 2.0395, 2e-3);
    EXPECT_NEAR(student_t(60), 2.0003, 1e-3);
    EXPECT_NEAR(student_t(1000), 1.9623, 1e-3);
}

/// Student's own data on sleep, drug 1 (1908): 0.75 +- 2.262 * 0.5657.
TEST(MeanInterval, of_ten_hours_of_sleep) {
    const Interval mean = mean_interval({0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0});
    EXPECT_NEAR(mean.value, 0.75, 1e-12);
    EXPECT_NEAR(mean.low, -0.5297, 1e-3);
    EXPECT_NEAR(mean.high, 2.0297, 1e-3);
    EXPECT_EQ(mean_interval({3}).low, 3);
}

TEST(RatioInterval, knows_a_ratio_and_its_inverse) {
    const Interval ratio = ratio_interval({2, 8}, {1, 1});
    EXPECT_NEAR(ratio.value, 4, 1e-12);
    // The logarithms' spread is ln 2 about their mean, with one degree of freedom.
    EXPECT_NEAR(std::log(ratio.high / 4), student_t(1) * std::log(2.0), 1e-6);
    const Interval inverse = ratio_interval({1, 1}, {2, 8});
    EXPECT_NEAR(inverse.low * ratio.high, 1, 1e-9);
    EXPECT_TRUE(std::isnan(ratio_interval({1}, {1, 2}).value));
    EXPECT_TRUE(std::isnan(ratio_interval({1, -1}, {1, 2}).value));
}

/// Of 4,000 pairs of five log-normal numbers each, 95% of the intervals hold the truth: between 94%
/// and 96.5% (four errors of 0.35%; Welch's degrees are floored, so a little more than 95%).
TEST(RatioInterval, holds_the_truth_as_often_as_it_says) {
    constexpr int kTrials = 4000;
    RandomStream random(5, Purpose::test, 0, 0);
    const auto normal = [&] {  // Box and Muller
        return std::sqrt(-2 * std::log(random.next())) *
               std::cos(6.283185307179586 * random.next());
    };
    int held = 0;
    for (int i = 0; i < kTrials; ++i) {
        std::vector<double> a;
        std::vector<double> b;
        for (int k = 0; k < 5; ++k) {
            a.push_back(3 * std::exp(0.2 * normal()));
            b.push_back(std::exp(0.5 * normal()));
        }
        const Interval ratio = ratio_interval(a, b);
        held += ratio.low <= 3 && 3 <= ratio.high ? 1 : 0;
    }
    EXPECT_GT(held, kTrials * 94 / 100);
    EXPECT_LT(held, kTrials * 965 / 1000);
}

TEST(RankCorrelation, of_orders_alike_reversed_and_tied) {
    EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {10, 20, 25, 1000}), 1, 1e-12);
    EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {4, 3, 2, -1}), -1, 1e-12);
    // One neighbouring pair changed: 1 - 6 * 2 / (4 * 15).
    EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {1, 3, 2, 4}), 0.8, 1e-12);
    EXPECT_NEAR(rank_correlation({1, 2, 2, 3}, {1, 2, 2, 3}), 1, 1e-12);
}

}  // namespace
}  // namespace sunfleck::engine
