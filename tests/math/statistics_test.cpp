// Running means against two-pass sums; tail probabilities against printed tables.
#include "math/statistics.h"

#include "core/random.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sunfleck::engine {
namespace {

TEST(RunningMean, agrees_with_two_passes_far_from_zero) {
    RandomStream stream(3, Purpose::test, 0, 0);
    std::vector<double> values(1000);
    for (double& value : values) value = 1e6 + stream.next();
    RunningMean running;
    double sum = 0;
    for (const double value : values) {
        running.add(value);
        sum += value;
    }
    const double mean = sum / 1000;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    EXPECT_EQ(running.count(), 1000U);
    EXPECT_NEAR(running.mean(), mean, 1e-9);
    EXPECT_NEAR(running.variance(), squares / 999, 1e-9);
    EXPECT_NEAR(running.standard_error(), std::sqrt(squares / 999 / 1000), 1e-9);
}

TEST(RunningMean, joined_is_as_if_added_in_turn) {
    RandomStream stream(4, Purpose::test, 0, 0);
    RunningMean whole;
    RunningMean first;
    RunningMean second;
    for (int i = 0; i < 100; ++i) {
        const double value = stream.next();
        whole.add(value);
        (i < 30 ? first : second).add(value);
    }
    RunningMean joined;
    joined.add(RunningMean());
    joined.add(first);
    joined.add(second);
    EXPECT_EQ(joined.count(), 100U);
    EXPECT_NEAR(joined.mean(), whole.mean(), 1e-14);
    EXPECT_NEAR(joined.variance(), whole.variance(), 1e-14);
}

TEST(RunningMean, empty_and_single_have_no_spread) {
    RunningMean one;
    EXPECT_EQ(one.mean(), 0);
    EXPECT_EQ(one.variance(), 0);
    one.add(5);
    EXPECT_EQ(one.mean(), 5);
    EXPECT_EQ(one.standard_error(), 0);
}

// NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.4: critical values of chi-square.
TEST(TailProbabilities, chi_square_as_printed) {
    using testing_support::chi_square_p;
    EXPECT_NEAR(chi_square_p(3.841, 1), 0.05, 1e-4);
    EXPECT_NEAR(chi_square_p(18.307, 10), 0.05, 1e-4);
    EXPECT_NEAR(chi_square_p(23.209, 10), 0.01, 1e-5);
    EXPECT_NEAR(chi_square_p(2.558, 10), 0.99, 1e-4);
    EXPECT_NEAR(chi_square_p(149.449, 100), 0.001, 1e-6);
    EXPECT_NEAR(chi_square_p(2 * std::log(1e12), 2), 1e-12, 1e-20);  // two degrees: exp(-x/2)
    EXPECT_EQ(chi_square_p(0, 3), 1);
    EXPECT_EQ(chi_square_p(std::numeric_limits<double>::infinity(), 3), 0);
    EXPECT_EQ(chi_square_p(std::numeric_limits<double>::quiet_NaN(), 3), 0);
}

TEST(TailProbabilities, normal_as_printed) {
    EXPECT_NEAR(testing_support::normal_p(1.959964), 0.05, 1e-7);
    EXPECT_NEAR(testing_support::normal_p(-3.290527), 0.001, 1e-9);
    EXPECT_NEAR(testing_support::normal_quantile(0.975), 1.959964, 1e-6);
    EXPECT_NEAR(testing_support::normal_quantile(0.0005), -3.290527, 1e-6);
    EXPECT_NEAR(testing_support::mean_p(1.2, 1, 0.1), 0.0455, 1e-4);
    EXPECT_EQ(testing_support::mean_p(1.2, 1, 0), 0);
    EXPECT_EQ(testing_support::mean_p(1, 1, 0), 1);
}

}  // namespace
}  // namespace sunfleck::engine
