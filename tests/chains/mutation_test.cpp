// Mutations: symmetric to the last bit, log-uniform, wrapped; scales are learned by the rule.
#include "chains/mutation.h"

#include "support/statistics.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

RandomStream numbers(std::uint32_t index) {
    return {3, Purpose::test, 0, index};
}

/// Signed distance in turns from 0.
double turns(std::uint64_t step) {
    return static_cast<double>(static_cast<std::int64_t>(step)) * 0x1p-64;
}

TEST(Moved, is_undone_by_the_other_side) {
    RandomStream stream = numbers(0);
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t dimension = stream.next_fraction();
        const std::uint32_t random = stream.next_word();
        const float scale = std::exp2(-30 * stream.next_float() + 4);
        const std::uint64_t there = moved(dimension, scale, random);
        EXPECT_EQ(moved(there, scale, random ^ 1U), dimension);
    }
}

TEST(Moved, does_not_depend_on_where_it_starts) {
    RandomStream stream = numbers(1);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t dimension = stream.next_fraction();
        const std::uint32_t random = stream.next_word();
        EXPECT_EQ(moved(dimension, 0.3F, random) - dimension, moved(0, 0.3F, random));
    }
}

// 200,000 steps in 80 bins, 40 a side: chi-square at 0.1%; sees a bin 10% too full.
TEST(Moved, sizes_are_log_uniform_over_a_decade) {
    constexpr int kBins = 40;
    constexpr int kSteps = 200'000;
    constexpr float kScale = 1e-3F;
    RandomStream stream = numbers(2);
    std::array<int, 2 * kBins> seen{};
    for (int i = 0; i < kSteps; ++i) {
        const double step = turns(moved(0, kScale, stream.next_word()));
        const double decades = std::log10(std::abs(step) / static_cast<double>(kScale));
        ASSERT_NEAR(decades, 0, 0.50005);
        const int bin = std::clamp(static_cast<int>((decades + 0.5) * kBins), 0, kBins - 1);
        ++seen.at(static_cast<std::size_t>(bin + (step < 0 ? kBins : 0)));
    }
    const double expected = static_cast<double>(kSteps) / (2 * kBins);
    double chi_square = 0;
    for (const int n : seen) chi_square += (n - expected) * (n - expected) / expected;
    EXPECT_GT(testing_support::chi_square_p(chi_square, 2 * kBins - 1), 1e-3);
}

TEST(Moved, goes_around_the_ends) {
    constexpr std::uint32_t kOutwards = 1U << 31U;  // xi of 1/2: exactly `scale`
    const auto step = static_cast<double>(moved(0, 0.25F, kOutwards | 1U)) * 0x1p-64;
    EXPECT_NEAR(step, 0.25, 1e-5);
    EXPECT_NEAR(to_unit(moved(1ULL << 60U, 0.25F, kOutwards)), 1 + 0.0625 - 0.25, 1e-5);
    EXPECT_NEAR(to_unit(moved(0xF000000000000000, 0.25F, kOutwards | 1U)), 0.1875, 1e-5);
    EXPECT_NEAR(to_unit(moved(0, 3.25F, kOutwards | 1U)), 0.25, 1e-4);  // three times around
}

// 100,000 mutations in 30 bins: chi-square at 0.1%. Two dimensions of one mutation differ by a
// decade at most, and its magnitude lies within a decade and a half of the scale.
TEST(LogUniformMove, magnitudes_are_log_uniform_over_three_decades) {
    constexpr int kBins = 30;
    constexpr int kMutations = 100'000;
    RandomStream stream = numbers(3);
    std::array<int, kBins> seen{};
    for (int i = 0; i < kMutations; ++i) {
        LogUniformMove move({{1e-3F, 1e-3F}}, 0, stream);
        double product = 1;
        std::array<double, 16> size{};
        for (std::uint32_t s = 0; s < 16; ++s) {
            size.at(s) = std::abs(turns(move(s, 0))) / 1e-3;
            product *= std::sqrt(std::sqrt(std::sqrt(std::sqrt(size.at(s)))));
        }
        const auto [least, most] = std::minmax_element(size.begin(), size.end());
        ASSERT_LE(*most / *least, 10.001);
        ASSERT_GT(*least, 0.99 * std::pow(10, -2));
        ASSERT_LT(*most, 1.01 * std::pow(10, 2));
        // The mean over dimensions blurs the magnitude; the middle of the range stays flat.
        const double decades = std::log10(product);
        if (std::abs(decades) < 1) ++seen.at(static_cast<std::size_t>((decades + 1.5) * kBins / 3));
    }
    double chi_square = 0;
    int bins = 0;
    for (const int n : seen) {
        if (n == 0) continue;
        const double expected = static_cast<double>(kMutations) / kBins;
        chi_square += (n - expected) * (n - expected) / expected;
        ++bins;
    }
    EXPECT_EQ(bins, 20);
    EXPECT_GT(testing_support::chi_square_p(chi_square, bins), 1e-3);
}

TEST(ApproximateExp2, is_near_and_rises_without_a_step) {
    float before = 0;
    for (int i = -60'000; i <= 60'000; ++i) {
        const float x = static_cast<float>(i) * 1e-4F;
        const float power = approximate_exp2(x);
        EXPECT_NEAR(power / std::exp2(x), 1, 1.1e-4) << x;
        EXPECT_GE(power, before) << x;
        before = power;
    }
}

TEST(LogUniformMove, the_second_kind_moves_bounces_farther) {
    const std::uint32_t bounce = dimension(0, BounceDimension::direction_u);
    const std::uint32_t emission = dimension(EmissionDimension::direction_u);
    for (std::uint32_t i = 0; i < 100; ++i) {
        std::array<double, 4> step{};
        for (const std::size_t kind : {0U, 1U}) {
            RandomStream stream = numbers(100 + i);
            RandomStream again = numbers(100 + i);
            const MutationScales scales{{1e-5F, 1e-5F}};
            step.at(2 * kind) = turns(LogUniformMove(scales, kind, stream)(emission, 0));
            step.at(2 * kind + 1) = turns(LogUniformMove(scales, kind, again)(bounce, 0));
        }
        EXPECT_EQ(step[0], step[1]);
        EXPECT_EQ(step[0], step[2]);
        EXPECT_NEAR(step[3] / step[2], 16, 1e-6);
    }
}

TEST(LogUniformMove, every_dimension_has_its_own_step) {
    RandomStream stream = numbers(7);
    LogUniformMove move({{0.1F, 0.2F}}, 1, stream);
    EXPECT_NE(move(0, 0), move(1, 0));
}

TEST(Adapted, follows_the_ratio_of_logarithms) {
    EXPECT_FLOAT_EQ(adapted(0.01F, {999, 499}, 0.5F), 0.01F * std::log(0.5F) / std::log(0.4995F));
    EXPECT_FLOAT_EQ(adapted(0.01F, {999, 299}, 0.5F), 0.01F * std::log(0.5F) / std::log(0.2995F));
    EXPECT_FLOAT_EQ(adapted(0.01F, {999, 599}, 0.5F), 0.01F * std::log(0.5F) / std::log(0.5995F));
}

TEST(Adapted, is_halved_or_doubled_at_most) {
    EXPECT_FLOAT_EQ(adapted(0.01F, {1000, 0}, 0.5F), 0.005F);
    EXPECT_FLOAT_EQ(adapted(0.01F, {1000, 1000}, 0.5F), 0.02F);
}

TEST(Adapted, waits_for_thirty_proposals) {
    EXPECT_EQ(adapted(0.01F, {29, 29}, 0.5F), 0.01F);
    EXPECT_NE(adapted(0.01F, {30, 30}, 0.5F), 0.01F);
}

TEST(Adapted, stays_within_half_a_turn) {
    EXPECT_EQ(adapted(0.4F, {1000, 1000}, 0.5F), 0.5F);
    EXPECT_EQ(adapted(0.5F, {1000, 1000}, 0.5F), 0.5F);
}

TEST(Adapted, each_kind_by_its_own_counts) {
    const MutationScales scales =
        adapted(MutationScales{{0.01F, 0.02F}}, {{{50, 0}, {50, 50}}}, 0.5F);
    EXPECT_FLOAT_EQ(scales.scale[0], 0.005F);
    EXPECT_FLOAT_EQ(scales.scale[1], 0.04F);
}

}  // namespace
}  // namespace sunfleck::engine
