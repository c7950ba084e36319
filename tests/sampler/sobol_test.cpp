// Sobol' points: known values, and that every elementary interval gets its share.
#include "sampler/sobol.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck {
namespace {

// First points of new-joe-kuo-6.21201 in natural (not Gray code) order, as fractions of 8.
TEST(Sobol, begins_as_published) {
    constexpr std::uint32_t kEighth = 1U << 29U;
    const std::uint32_t first_two[8][2] = {{0, 0}, {4, 4}, {2, 6}, {6, 2},
                                           {1, 5}, {5, 1}, {3, 3}, {7, 7}};
    for (std::uint32_t i = 0; i < 8; ++i)
        for (std::size_t d = 0; d < 2; ++d)
            EXPECT_EQ(sobol(i, d), first_two[i][d] * kEighth) << i << " " << d;
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
}  // namespace sunfleck
