// Arrays on large pages behave as any array; those of a page or more start at one.
#include "core/huge_pages.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <numeric>

namespace sunfleck::engine {
namespace {

TEST(HugePages, arrays_below_and_above_a_page) {
    constexpr std::size_t kOfPage = HugePages<double>::kPage / sizeof(double);
    for (const std::size_t count : {std::size_t{1}, kOfPage - 1, kOfPage, kOfPage + 1}) {
        HugeVector<double> values(count);
        std::iota(values.begin(), values.end(), 0.0);
        values.push_back(-1);
        HugeVector<double> copy = values;
        copy.shrink_to_fit();
        EXPECT_EQ(copy, values);
        EXPECT_EQ(copy[count - 1], static_cast<double>(count - 1));
        const auto place = std::bit_cast<std::uintptr_t>(copy.data());
        EXPECT_TRUE(count < kOfPage || place % HugePages<double>::kPage == 0);
    }
}

}  // namespace
}  // namespace sunfleck::engine
