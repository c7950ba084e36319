// The choice of a light: by power, in order, never one without power.
#include "light/choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

TEST(LightChoice, intervals_are_as_long_as_the_powers_and_in_order) {
    const LightChoice choice({1, 3, 4});
    EXPECT_FALSE(choice.empty());
    EXPECT_EQ(choice.total(), 8);
    EXPECT_EQ(choice.choose(0x1p-53).index, 0U);
    EXPECT_EQ(choice.choose(0.125 - 0x1p-53).index, 0U);
    EXPECT_EQ(choice.choose(0.125).index, 1U);
    EXPECT_EQ(choice.choose(0.5 - 0x1p-53).index, 1U);
    EXPECT_EQ(choice.choose(0.5).index, 2U);
    EXPECT_EQ(choice.choose(1 - 0x1p-53).index, 2U);
    EXPECT_EQ(choice.choose(0.3).probability, 0.375);
    EXPECT_EQ(choice.probability(2), 0.5);
}

TEST(LightChoice, lights_without_power_are_never_chosen) {
    const LightChoice choice({0, 2, 0, 0, 2, 0});
    for (int i = 0; i < 16; ++i) {
        const double u = i / 16.0 + 0x1p-53;
        const auto chosen = choice.choose(u);
        EXPECT_EQ(chosen.index, u < 0.5 ? 1U : 4U);
        EXPECT_EQ(chosen.probability, 0.5);
    }
    EXPECT_EQ(choice.choose(0.5).index, 4U);
    EXPECT_EQ(choice.choose(1 - 0x1p-53).index, 4U);
    for (const std::size_t dark : {0U, 2U, 3U, 5U}) EXPECT_EQ(choice.probability(dark), 0);
}

TEST(LightChoice, nothing_to_choose_is_empty) {
    EXPECT_TRUE(LightChoice().empty());
    EXPECT_TRUE(LightChoice(std::vector<double>{}).empty());
    EXPECT_TRUE(LightChoice({0, 0}).empty());
    EXPECT_EQ(LightChoice({0, 0}).probability(1), 0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(LightChoice({-1, nan, std::numeric_limits<double>::infinity()}).empty());
    const LightChoice one({-1, nan, 5});
    EXPECT_FALSE(one.empty());
    EXPECT_EQ(one.choose(0.01).index, 2U);
    EXPECT_EQ(one.probability(2), 1);
}

/// A million lights of powers over twelve decades: probabilities are those of the intervals.
TEST(LightChoice, probabilities_sum_to_one_and_belong_to_their_intervals) {
    std::vector<double> powers(1000000);
    for (std::size_t i = 0; i < powers.size(); ++i)
        powers[i] = std::pow(10, static_cast<int>(i % 13) - 6);
    const LightChoice choice(powers);
    double below = 0;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const double p = choice.probability(i);
        const bool look = i % 9973 == 0 && p > 1e-13;
        ASSERT_TRUE(!look || choice.choose(below + p / 2).index == i) << below << " " << p;
        below += p;
    }
    EXPECT_NEAR(below, 1, 1e-12);
}

}  // namespace
}  // namespace sunfleck::engine
