// Systematic sharing: exact, by running through all offsets.
#include "random_numbers/systematic_resampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace sunfleck::engine {
namespace {

/// The least fraction that below() maps to `offset` of n.
std::uint64_t fraction_of(std::uint64_t offset, std::uint64_t n) {
    return (((offset << 32U) + n - 1) / n) << 32U;
}

TEST(Below, each_number_has_its_stretch_of_fractions) {
    for (const std::uint64_t n : {1ULL, 2ULL, 7ULL, 1000ULL, 4294967295ULL}) {
        EXPECT_EQ(below(0, n), 0U);
        EXPECT_EQ(below(~0ULL, n), n - 1);
        for (const std::uint64_t k : {std::uint64_t{1}, n / 3, n / 2, n - 1}) {
            if (k == 0 || k >= n) continue;
            EXPECT_EQ(below(fraction_of(k, n), n), k);
            EXPECT_EQ(below(fraction_of(k, n) - 1, n), k - 1);
        }
    }
}

TEST(SystematicResampling, sum_to_the_whole_and_hardly_differ) {
    for (std::uint64_t things = 0; things <= 24; ++things)
        for (std::uint64_t shares = 1; shares <= 13; ++shares)
            for (std::uint64_t offset = 0; offset < shares; ++offset) {
                const SystematicResampling length(things, shares, fraction_of(offset, shares));
                std::uint64_t sum = 0;
                for (std::uint64_t j = 0; j < shares; ++j) {
                    sum += length(j);
                    EXPECT_GE(length(j), things / shares);
                    EXPECT_LE(length(j), (things + shares - 1) / shares);
                }
                EXPECT_EQ(sum, things);
            }
}

TEST(SystematicResampling, every_share_has_the_same_distribution) {
    for (std::uint64_t things = 0; things <= 24; ++things)
        for (std::uint64_t shares = 1; shares <= 13; ++shares) {
            std::vector<std::map<std::uint64_t, int>> seen(shares);
            for (std::uint64_t offset = 0; offset < shares; ++offset) {
                const SystematicResampling length(things, shares, fraction_of(offset, shares));
                for (std::uint64_t j = 0; j < shares; ++j) ++seen[j][length(j)];
            }
            for (const auto& lengths : seen) EXPECT_EQ(lengths, seen[0]) << things << "/" << shares;
        }
}

TEST(Systematic, large_numbers_do_not_overflow) {
    constexpr std::uint64_t kMost = (1ULL << 31U) - 1;
    const SystematicResampling length(kMost, kMost - 1, ~0ULL);
    std::uint64_t longest = 0;
    for (const std::uint64_t j : {std::uint64_t{0}, kMost / 2, kMost - 2})
        longest = std::max(longest, length(j));
    EXPECT_LE(longest, 2U);
}

}  // namespace
}  // namespace sunfleck::engine
