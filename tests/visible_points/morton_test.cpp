// Sorting by Morton codes is stable, and the same on any number of threads.
#include "visible_points/morton.h"

#include "core/parallel.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// @param clear  bits that are zero in all codes. Many codes are there more than once.
MortonKeys random_keys(std::size_t count, std::uint64_t clear) {
    RandomStream stream(5, Purpose::test, static_cast<std::uint32_t>(count), 0);
    MortonKeys keys(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_new = i == 0 || stream.next() < 0.7;
        const std::uint64_t code = is_new ? stream.next_fraction() >> 1U : keys[i / 2].code;
        keys[i] = {code & ~clear, static_cast<std::uint32_t>(i), 7};
    }
    return keys;
}

void expect_sorted(MortonKeys keys, unsigned bits) {
    MortonKeys expected = keys;
    const auto upper = [&](const MortonKey& key) { return key.code >> (63 - bits); };
    std::stable_sort(expected.begin(), expected.end(),
                     [&](const auto& a, const auto& b) { return upper(a) < upper(b); });
    sort_by_code(keys, bits);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ASSERT_EQ(keys[i].code, expected[i].code) << i << " of " << keys.size();
        ASSERT_EQ(keys[i].item, expected[i].item) << i << " of " << keys.size();
    }
}

TEST(Morton, sort_is_stable_on_any_number_of_threads) {
    for (const std::size_t threads : {1U, 3U})
        for (const std::size_t count : {0U, 1U, 2U, 1000U, 16384U, 16385U, 100'000U}) {
            const ThreadLimit limit(threads);
            expect_sorted(random_keys(count, 0), 63);
            expect_sorted(random_keys(count, 0), 33);
            expect_sorted(random_keys(count, 0x3FFFFFFFULL << 20U), 63);
        }
}

TEST(Morton, neighbours_in_a_cell_have_neighbouring_codes) {
    const MortonGrid grid(Vec3(0), Vec3(1));
    EXPECT_EQ(grid.code(Vec3(0)), 0U);
    EXPECT_EQ(grid.code(Vec3(1)), (std::uint64_t{1} << 63U) - 1);
    EXPECT_EQ(grid.code(Vec3(2)), grid.code(Vec3(1)));
    EXPECT_LT(grid.code(Vec3(0.4F)), grid.code(Vec3(0.1F, 0.1F, 0.6F)));
}

}  // namespace
}  // namespace sunfleck::engine
