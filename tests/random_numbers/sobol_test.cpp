// Sobol' points: known values, and that every elementary interval gets its share.
#include "random_numbers/sobol.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace sunfleck::engine {
namespace {

// First points of new-joe-kuo-6.21201 in natural (not Gray code) order, as fractions of 8.
TEST(Sobol, begins_as_published) {
    constexpr std::uint32_t kEighth = 1U << 29U;
    const std::array<std::uint32_t, 8> first = {0, 4, 2, 6, 1, 5, 3, 7};
    const std::array<std::uint32_t, 8> second = {0, 4, 6, 2, 5, 1, 3, 7};
    for (std::uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(sobol(i, 0), first.at(i) * kEighth) << i;
        EXPECT_EQ(sobol(i, 1), second.at(i) * kEighth) << i;
    }
}

TEST(Sobol, every_dimension_visits_each_interval_once) {
    for (std::size_t d = 0; d < kSobolDimensions; ++d) {
        std::set<std::uint32_t> cells;
        for (std::uint32_t i = 0; i < 1024; ++i) cells.insert(sobol(i, d) >> 22U);
        EXPECT_EQ(cells.size(), 1024U) << d;
    }
}

TEST(Sobol, first_pair_is_a_net) {
    for (unsigned split = 0; split <= 10; ++split) {
        std::set<std::uint32_t> cells;
        for (std::uint32_t i = 0; i < 1024; ++i) {
            const std::uint64_t x = std::uint64_t{sobol(i, 0)} >> (32U - split);
            const std::uint64_t y = std::uint64_t{sobol(i, 1)} >> (22U + split);
            cells.insert(static_cast<std::uint32_t>((x << (10U - split)) | y));
        }
        EXPECT_EQ(cells.size(), 1024U) << split;
    }
}

}  // namespace
}  // namespace sunfleck::engine
