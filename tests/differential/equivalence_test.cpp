// The decision: equal, different, undecided; and the tail of Student's t that it rests on.
#include "differential/equivalence.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace sunfleck::engine::differential {
namespace {

TEST(Equivalence, student_tails_are_those_of_closed_forms) {
    for (const double t : {-3.0, -0.5, 0.0, 0.2, 1.0, 4.0, 30.0}) {
        EXPECT_NEAR(student_tail(t, 1), 0.5 - std::atan(t) / std::numbers::pi, 1e-12);
        EXPECT_NEAR(student_tail(t, 2), 0.5 - t / (2 * std::sqrt(2 + t * t)), 1e-12);
    }
    EXPECT_NEAR(student_tail(2.228138852, 10), 0.025, 1e-9);  // printed tables
    EXPECT_NEAR(student_tail(1.959963985, 1e9), 0.025, 1e-7);
    EXPECT_NEAR(student_tail(63.65674116, 1) * 2, 0.01, 1e-9);
}

TEST(Equivalence, near_means_with_small_errors_are_equal) {
    EXPECT_EQ(decide({1.01, 0.001, 7}, {1, 0.001, 7}, 0.02, 1e-5), Verdict::equal);
}

TEST(Equivalence, means_beyond_the_band_are_different) {
    EXPECT_EQ(decide({1.05, 0.001, 7}, {1, 0.001, 7}, 0.02, 1e-5), Verdict::different);
    EXPECT_EQ(decide({0.95, 0.001, 7}, {1, 0.001, 7}, 0.02, 1e-5), Verdict::different);
}

TEST(Equivalence, large_errors_decide_nothing) {
    EXPECT_EQ(decide({1.05, 0.02, 7}, {1, 0.02, 7}, 0.02, 1e-5), Verdict::undecided);
    EXPECT_EQ(decide({1, 0.02, 7}, {1, 0.02, 7}, 0.02, 1e-5), Verdict::undecided);
}

TEST(Equivalence, without_noise_the_band_alone_decides) {
    EXPECT_EQ(decide({0, 0, 3}, {0, 0, 3}, 0, 1e-5), Verdict::equal);
    EXPECT_EQ(decide({1, 0, 3}, {0, 0, 3}, 0.5, 1e-5), Verdict::different);
}

/// The same estimator twice, 20,000 times, at a significance of 1%; fails for a test that takes its
/// errors for known (4% of four renders). Seed 5; the smallest effect seen is half a per cent.
TEST(Equivalence, false_alarms_are_as_rare_as_asked_for) {
    RandomStream random(5, Purpose::test, 0, 0);
    const auto normal = [&] {
        return std::sqrt(-2 * std::log(random.next())) *
               std::cos(2 * std::numbers::pi * random.next());
    };
    const auto four = [&] { return mean_of({normal(), normal(), normal(), normal()}); };
    constexpr int kTrials = 20000;
    int alarms = 0;
    for (int i = 0; i < kTrials; ++i)
        alarms += decide(four(), four(), 0, 0.005) == Verdict::different ? 1 : 0;  // of each side
    EXPECT_LT(alarms, 0.013 * kTrials);
    EXPECT_GT(alarms, 0.004 * kTrials);
}

TEST(Equivalence, a_prior_counts_as_so_many_values) {
    const MeanOf plain = mean_of({1, 3});
    EXPECT_DOUBLE_EQ(plain.mean, 2);
    EXPECT_DOUBLE_EQ(plain.error, 1);
    const MeanOf with_prior = mean_of({1, 3}, {.variance = 8, .degrees = 3});
    EXPECT_DOUBLE_EQ(with_prior.error, std::sqrt((2.0 + 3 * 8) / 4 / 2));
    EXPECT_DOUBLE_EQ(with_prior.degrees, 4);
}

}  // namespace
}  // namespace sunfleck::engine::differential
