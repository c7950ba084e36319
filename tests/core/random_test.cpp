// Tests core/random.h: the authors' known answers, and that a stream is a function of its name.
#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kOnes32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kOnes64 = std::numeric_limits<std::uint64_t>::max();

// Known answers of philox4x32-10: Random123 1.14, file kat_vectors. Key words: low, then high.
static_assert(philox({0, 0, 0, 0}, 0) ==
              RandomBlock{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
static_assert(philox({kOnes32, kOnes32, kOnes32, kOnes32}, kOnes64) ==
              RandomBlock{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
static_assert(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0'a4093822) ==
              RandomBlock{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});

// The ends of the two maps to the open interval, exactly.
static_assert(to_unit(0) == 0x1p-53 && to_unit(kOnes64) == 1 - 0x1p-53);
static_assert(to_unit_float(0) == 0x1p-24F && to_unit_float(kOnes64) == 1 - 0x1p-24F);
static_assert(to_unit(kOnes64 / 2 + 1) > 0.5 && to_unit(kOnes64 / 2) < 0.5);

TEST(RandomStream, does_not_depend_on_the_order_of_asking) {
    constexpr std::uint32_t kCount = 101;
    RandomStream forward(7, Purpose::test, 3, 5);
    std::vector<std::uint64_t> in_order;
    for (std::uint32_t i = 0; i < kCount; ++i) in_order.push_back(forward.next_fraction());

    RandomStream backward(7, Purpose::test, 3, 5);
    for (std::uint32_t i = kCount; i-- > 0;) EXPECT_EQ(in_order[i], backward.at(i)) << i;

    RandomStream jumping(7, Purpose::test, 3, 5);
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const std::uint32_t j = i * 37 % kCount;
        EXPECT_EQ(in_order[j], jumping.at(j)) << j;
    }
}

TEST(RandomStream, at_does_not_move_next) {
    RandomStream plain(1, Purpose::test, 0, 0);
    RandomStream asked(1, Purpose::test, 0, 0);
    EXPECT_EQ(plain.next_fraction(), asked.next_fraction());
    asked.at(1000);
    EXPECT_EQ(plain.next_fraction(), asked.next_fraction());
}

TEST(RandomStream, a_number_is_two_words) {
    RandomStream numbers(1, Purpose::test, 0, 0);
    RandomStream words(1, Purpose::test, 0, 0);
    for (std::uint32_t i = 0; i < 100; ++i) {
        const std::uint64_t high = words.word(2 * i);
        EXPECT_EQ(numbers.at(i), high << 32U | words.word(2 * i + 1)) << i;
    }
}

TEST(RandomStream, next_word_and_next_fraction_read_no_bit_twice) {
    RandomStream stream(1, Purpose::test, 0, 0);
    RandomStream same(1, Purpose::test, 0, 0);
    EXPECT_EQ(stream.next_word(), same.word(0));
    EXPECT_EQ(stream.next_word(), same.word(1));
    EXPECT_EQ(stream.next_fraction(), same.at(1));  // words 2 and 3
    EXPECT_EQ(stream.next_word(), same.word(4));
    EXPECT_EQ(stream.next_fraction(), same.at(3));  // words 6 and 7: 5 is half a number
    EXPECT_EQ(stream.next_word(), same.word(8));
}

TEST(RandomStream, a_word_is_the_float_of_a_fraction_that_begins_with_it) {
    RandomStream stream(1, Purpose::test, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const std::uint32_t word = stream.next_word();
        const std::uint64_t below = stream.next_word();
        EXPECT_EQ(word_to_unit_float(word), to_unit_float(std::uint64_t{word} << 32U | below));
    }
}

TEST(RandomStream, reaches_its_last_position) {
    RandomStream stream(1, Purpose::test, 0, 0);
    const std::uint64_t last = stream.at(kOnes32);
    EXPECT_NE(stream.at(kOnes32 - 1), last);
    EXPECT_NE(stream.at(0), last);
    EXPECT_EQ(stream.at(kOnes32), last);
}

TEST(RandomStream, every_part_of_the_name_makes_another_stream) {
    std::set<std::uint64_t> seen;
    int streams = 0;
    const auto meet = [&](RandomStream stream) {
        ++streams;
        for (std::uint32_t i = 0; i < 8; ++i) seen.insert(stream.at(i));
    };
    meet({0, Purpose::test, 0, 0});
    for (unsigned bit = 0; bit < 64; ++bit) meet({std::uint64_t{1} << bit, Purpose::test, 0, 0});
    for (unsigned bit = 0; bit < 32; ++bit) {
        meet({0, Purpose::test, 1U << bit, 0});
        meet({0, Purpose::test, 0, 1U << bit});
    }
    for (std::uint32_t p = 0; p < static_cast<std::uint32_t>(Purpose::test); ++p)
        meet({0, static_cast<Purpose>(p), 0, 0});
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(8 * streams));
}

TEST(RandomStream, a_pass_names_its_streams) {
    const PassId pass{11, 12};
    RandomStream named = pass.stream(Purpose::camera, 13);
    RandomStream same(11, Purpose::camera, 12, 13);
    EXPECT_EQ(named.next_fraction(), same.next_fraction());
}

/// Seed 1, 2^20 numbers, each bit of the fraction: 64 two-sided tests at 4.9 sigma together reject
/// a right generator once in 16,000; a bit that is set 0.3% too often is seen.
TEST(RandomStream, bits_are_fair) {
    constexpr int kCount = 1 << 20;
    constexpr double kSigma = 512;  // sqrt(kCount) / 2
    std::vector<int> set_bits(64, 0);
    RandomStream stream(1, Purpose::test, 0, 0);
    for (int i = 0; i < kCount; ++i) {
        const std::uint64_t fraction = stream.next_fraction();
        for (unsigned bit = 0; bit < 64; ++bit)
            set_bits[bit] += static_cast<int>(fraction >> bit & 1U);
    }
    for (std::size_t bit = 0; bit < 64; ++bit)
        EXPECT_NEAR(set_bits[bit], kCount / 2.0, 4.9 * kSigma) << "bit " << bit;
}

TEST(RandomStream, next_and_next_float_are_the_fraction_rounded_into_the_open_interval) {
    RandomStream a(3, Purpose::test, 0, 0);
    RandomStream b(3, Purpose::test, 0, 0);
    for (std::uint32_t i = 0; i < 1000; i += 2) {
        const double turn = static_cast<double>(b.at(i)) * 0x1p-64;
        EXPECT_NEAR(a.next(), turn, 0x1p-52);
        EXPECT_NEAR(a.next_float(), static_cast<double>(b.at(i + 1)) * 0x1p-64, 0x1p-23);
    }
}

}  // namespace
}  // namespace sunfleck::engine
