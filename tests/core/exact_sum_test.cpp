// Tests core/exact_sum.h: the sum has the same bits in any order and on any number of threads.
#include "core/exact_sum.h"

#include "core/parallel.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::uint64_t kOnes = std::numeric_limits<std::uint64_t>::max();
constexpr std::int64_t kHighest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min();

FixedPoint sum(const std::vector<FixedPoint>& terms) {
    FixedPoint total;
    for (const FixedPoint& term : terms) total += term;
    return total;
}

/// Terms of both signs over sixty octaves, so that carries and borrows happen all the time.
std::vector<FixedPoint> mixed_terms(std::size_t count) {
    RandomStream stream(5, Purpose::test, 0, 0);
    std::vector<FixedPoint> terms;
    for (std::size_t i = 0; i < count; ++i) {
        const double size = std::ldexp(stream.next(), static_cast<int>(60 * stream.next()) - 40);
        terms.push_back(FixedPoint::from_double(stream.next() < 0.5 ? -size : size));
    }
    return terms;
}

void shuffle(std::vector<FixedPoint>& terms, std::uint32_t number) {
    RandomStream stream(6, Purpose::test, 0, number);
    for (std::size_t i = terms.size(); i > 1; --i)
        std::swap(terms[i - 1], terms[stream.next_fraction() % i]);
}

TEST(FixedPoint, terms_that_fit_are_exact) {
    for (const double x : {0.0, 1.0, -1.0, 0.5, -0.5, 1.5, -1.5, 0x1p-64, -0x1p-64, 0x1.fffffep-41,
                           -0x1.fffffep-41, 0x1p47, -0x1p47, 12345.678F + 0.0, 1 - 0x1p-53})
        EXPECT_EQ(FixedPoint::from_double(x).to_double(), x) << x;
}

TEST(FixedPoint, shifted_down_is_a_fraction_rounded_down) {
    for (const double x : {0.0, 1.0, -1.0, 12345.625, -12345.625, 0x1p40, -0x1p40})
        EXPECT_EQ(FixedPoint::from_double(x).shifted_down(3).to_double(), x / 8) << x;
    EXPECT_EQ((FixedPoint{0, 15}).shifted_down(3), (FixedPoint{0, 1}));
    EXPECT_EQ((-FixedPoint{0, 15}).shifted_down(3), (-FixedPoint{0, 2}));
    EXPECT_EQ((FixedPoint{-3, 7}).shifted_down(0), (FixedPoint{-3, 7}));
}

TEST(FixedPoint, bits_below_the_unit_are_cut_towards_zero) {
    EXPECT_EQ(FixedPoint::from_double(0x1.8p-64), (FixedPoint{0, 1}));
    EXPECT_EQ(FixedPoint::from_double(-0x1.8p-64), (FixedPoint{-1, kOnes}));
    EXPECT_EQ(FixedPoint::from_double(0x1.fp-65), FixedPoint{});
    EXPECT_EQ(FixedPoint::from_double(-0x1.fp-65), FixedPoint{});
    EXPECT_EQ(FixedPoint::from_double(-0.0), FixedPoint{});
    EXPECT_EQ(FixedPoint::from_double(std::numeric_limits<double>::denorm_min()), FixedPoint{});
}

TEST(FixedPoint, carries_and_borrows) {
    FixedPoint a{0, kOnes};
    a += {0, 1};
    EXPECT_EQ(a, (FixedPoint{1, 0}));
    a += {-1, kOnes};  // minus the unit
    EXPECT_EQ(a, (FixedPoint{0, kOnes}));
    a += {0, kOnes};
    EXPECT_EQ(a, (FixedPoint{1, kOnes - 1}));
    a += {-2, 0};
    EXPECT_EQ(a, (FixedPoint{-1, kOnes - 1}));
}

TEST(FixedPoint, negation) {
    EXPECT_EQ(-FixedPoint{}, FixedPoint{});
    EXPECT_EQ((-FixedPoint{1, 0}), (FixedPoint{-1, 0}));
    EXPECT_EQ((-FixedPoint{0, 1}), (FixedPoint{-1, kOnes}));
    for (const FixedPoint& x : mixed_terms(1000)) {
        FixedPoint zero = x;
        zero += -x;
        EXPECT_EQ(zero, FixedPoint{});
        EXPECT_EQ(-(-x), x);
        EXPECT_EQ((-x).to_double(), -x.to_double());
    }
}

TEST(FixedPoint, small_negative_values_keep_their_digits) {
    EXPECT_EQ((FixedPoint{-1, kOnes}).to_double(), -0x1p-64);
    EXPECT_EQ((FixedPoint{-1, kOnes - 2}).to_double(), -0x3p-64);
    EXPECT_EQ(FixedPoint::from_double(-0x1.23456789abcdp-12).to_double(), -0x1.23456789abcdp-12);
}

TEST(FixedPoint, ends_of_the_range) {
    EXPECT_EQ((FixedPoint{kHighest, kOnes}).to_double(), 0x1p63);
    EXPECT_EQ((FixedPoint{kLowest, 0}).to_double(), -0x1p63);
    FixedPoint wrapped{kHighest, kOnes};
    wrapped += {0, 1};
    EXPECT_EQ(wrapped, (FixedPoint{kLowest, 0}));
}

TEST(FixedPoint, fewer_than_two_to_the_16_largest_terms_fit) {
    for (const double sign : {1.0, -1.0}) {
        FixedPoint total;
        for (int i = 1; i < 1 << 16; ++i) total += FixedPoint::from_double(sign * kLargestTerm);
        EXPECT_EQ(total.to_double(), sign * 65535 * 0x1p47);
    }
}

TEST(FixedPoint, order_and_grouping_do_not_matter) {
    std::vector<FixedPoint> terms = mixed_terms(3000);
    const FixedPoint expected = sum(terms);
    for (std::uint32_t order = 0; order < 50; ++order) {
        shuffle(terms, order);
        EXPECT_EQ(sum(terms), expected) << order;

        const auto cut = terms.begin() + 60 * static_cast<std::ptrdiff_t>(order);
        FixedPoint right = sum({cut, terms.end()});
        right += sum({terms.begin(), cut});
        EXPECT_EQ(right, expected) << order;
    }
}

TEST(FixedPoint, sums_what_doubles_lose) {
    FixedPoint total;
    total += FixedPoint::from_double(0x1p46);
    for (int i = 0; i < 1024; ++i) total += FixedPoint::from_double(0x1p-30);
    total += FixedPoint::from_double(-0x1p46);
    EXPECT_EQ(total.to_double(), 0x1p-20);
}

TEST(AtomicFixedPoint, threads_in_any_order_give_the_same_bits) {
    const std::vector<FixedPoint> terms = mixed_terms(20000);
    const FixedPoint expected = sum(terms);
    for (const std::size_t threads : {1U, 2U, 5U, 16U}) {
        const ThreadLimit limit(threads);
        AtomicFixedPoint total;
        parallel_for(terms.size(), [&](std::size_t i) { total.add(terms[i]); });
        EXPECT_EQ(total.value(), expected) << threads << " threads";
    }
}

TEST(AtomicFixedPoint, carries_as_the_plain_one_does) {
    const std::vector<FixedPoint> edges = {{0, 0},      {0, 1},          {0, kOnes},
                                           {-1, kOnes}, {-1, 0},         {1, 0},
                                           {1, kOnes},  {-1, kOnes - 1}, {-2, 1}};
    for (const FixedPoint& a : edges) {
        for (const FixedPoint& b : edges) {
            AtomicFixedPoint total;
            total.add(a);
            total.add(b);
            EXPECT_EQ(total.value(), sum({a, b}));
        }
    }
}

}  // namespace
}  // namespace sunfleck::engine
