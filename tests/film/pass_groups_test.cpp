// Groups of passes: which passes are summed together, and what they count.
#include "film/pass_groups.h"

#include "math/wavelengths.h"
#include "synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

using testing_support::set_of;
using Ranges = std::vector<PassRange>;

/// The largest gap between fractions of the wavelengths' distribution, over the mean gap.
double largest_gap(const PassRange& group) {
    std::vector<float> nm;
    std::vector<float> fractions;
    for (std::uint64_t pass = group.begin; pass < group.end; ++pass) {
        const Wavelengths drawn = Wavelengths::of_pass({5, static_cast<std::uint32_t>(pass)});
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
            nm.push_back(drawn.nm[wavelength]);
    }
    // Places of the finest lattice, of all 16 passes: ranks among its wavelengths.
    std::vector<float> all;
    for (std::uint32_t pass = 0; pass < kBatchPasses; ++pass) {
        const Wavelengths drawn = Wavelengths::of_pass({5, pass});
        all.insert(all.end(), drawn.nm.begin(), drawn.nm.end());
    }
    std::sort(all.begin(), all.end());
    std::sort(nm.begin(), nm.end());
    for (const float one : nm)
        fractions.push_back(
            static_cast<float>(std::lower_bound(all.begin(), all.end(), one) - all.begin()));
    float most = fractions.front() + static_cast<float>(all.size()) - fractions.back();
    for (std::size_t i = 0; i + 1 < fractions.size(); ++i)
        most = std::max(most, fractions[i + 1] - fractions[i]);
    return most * static_cast<double>(nm.size()) / static_cast<double>(all.size());
}

TEST(PassGroups, an_open_batch_has_its_start_and_what_follows_by_powers_of_two) {
    EXPECT_EQ(open_groups(set_of({{0, 1}})), (Ranges{{0, 1}}));
    EXPECT_EQ(open_groups(set_of({{0, 3}})), (Ranges{{0, 2}, {2, 4}}));
    EXPECT_EQ(open_groups(set_of({{0, 7}})), (Ranges{{0, 4}, {4, 6}, {6, 8}}));
    EXPECT_EQ(open_groups(set_of({{0, 15}})), (Ranges{{0, 12}, {12, 16}}));
    EXPECT_EQ(open_groups(set_of({{0, 16}})), Ranges());
    EXPECT_EQ(open_groups(set_of({{5, 7}, {9, 20}, {32, 64}, {70, 71}, {72, 73}})),
              (Ranges{{4, 6}, {6, 8}, {8, 12}, {12, 16}, {16, 20}, {68, 72}, {72, 76}}));
}

TEST(PassGroups, a_long_range_takes_no_time) {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 60U;
    EXPECT_EQ(open_groups(set_of({{0, kMost}})), Ranges());
    EXPECT_EQ(open_groups(set_of({{5, kMost + 2}})),
              (Ranges{{4, 6}, {6, 8}, {8, 12}, {12, 16}, {kMost, kMost + 2}}));
}

/// So that sums can be joined, and need not be taken apart.
TEST(PassGroups, passes_of_one_group_stay_in_one_while_others_come) {
    for (std::uint32_t held = 0; held < 1U << 16U; held += 7)
        for (std::uint32_t more = 0; more < 16; ++more) {
            PassSet before;
            for (std::uint32_t pass = 0; pass < 16; ++pass)
                if ((held >> pass & 1U) != 0) before.insert({pass, pass + 1});
            if ((held >> more & 1U) != 0) continue;
            PassSet after = before;
            after.insert({more, more + 1});
            for (const PassRange& group : open_groups(before)) {
                const PassRange wider = group_of(after, group.begin);
                ASSERT_TRUE(wider.begin <= group.begin && group.end <= wider.end) << held;
            }
        }
}

TEST(PassGroups, wavelengths_of_a_group_are_spread_evenly) {
    for (const PassRange& group :
         Ranges{{0, 1}, {0, 2}, {0, 4}, {0, 8}, {1, 2}, {2, 4}, {4, 8}, {8, 12}, {12, 16}})
        EXPECT_NEAR(largest_gap(group), 1, 1e-6) << group.begin << ' ' << group.end;
    EXPECT_NEAR(largest_gap({0, 12}), 1.5, 1e-6);
    EXPECT_GT(largest_gap({0, 9}), 1.1);
}

TEST(PassGroups, fewer_than_eight_passes_count_less_and_incomplete_groups_not_at_all) {
    const PassSet passes = set_of({{0, 16}, {16, 20}, {32, 41}, {64, 80}});
    EXPECT_EQ(share_of_group(passes, {0, 16}), 1);
    EXPECT_EQ(share_of_group(passes, {16, 20}), 0.25);
    EXPECT_EQ(share_of_group(passes, {32, 40}), 1);
    EXPECT_EQ(share_of_group(passes, {40, 44}), 0);
}

}  // namespace
}  // namespace sunfleck::engine
