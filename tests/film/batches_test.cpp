// Which groups of passes are batches, early and whole ones.
#include "film/batches.h"

#include "film/pass_groups.h"
#include "synthetic.h"
#include "visible_points/radius.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::set_of;
using Ranges = std::vector<PassRange>;

void expect_complete(const Ranges& ranges, double count, double passes) {
    const CompleteBatches complete = complete_batches(FilmKey(), set_of(ranges));
    EXPECT_EQ(complete.count, count);
    EXPECT_EQ(complete.passes, passes);
}

TEST(Batches, whole_ones_have_sixteen_passes) {
    PassSet passes = set_of({{9, 20}, {32, 64}});
    EXPECT_EQ(whole_batches(passes), 2U);
    passes.insert({20, 32});
    EXPECT_EQ(whole_batches(passes), 3U);
}

TEST(Batches, early_ones_are_groups_of_the_first_whole_one) {
    EXPECT_EQ(early_batches(set_of({{0, 3}})), (Ranges{{0, 1}, {1, 2}}));
    EXPECT_EQ(early_batches(set_of({{1, 9}, {12, 40}})),
              (Ranges{{1, 2}, {2, 4}, {4, 6}, {6, 8}, {12, 16}}));
    EXPECT_EQ(early_batches(set_of({{0, 63}})),
              (Ranges{{0, 1}, {1, 2}, {2, 4}, {4, 6}, {6, 8}, {8, 12}, {12, 16}}));
    EXPECT_EQ(early_batches(set_of({{16, 48}})), Ranges());
}

TEST(Batches, four_whole_ones_end_early_ones) {
    EXPECT_TRUE(has_early_batches(set_of({{5, 63}})));
    EXPECT_FALSE(has_early_batches(set_of({{0, 64}})));
    EXPECT_FALSE(has_early_batches(set_of({{0, 7}, {16, 80}})));
    EXPECT_EQ(early_batches(set_of({{0, 7}, {16, 80}})), Ranges());
}

TEST(Batches, each_pass_counts_in_one) {
    expect_complete({{0, 1}}, 1, 1);
    expect_complete({{0, 8}}, 5, 8);
    expect_complete({{0, 16}}, 7, 16);
    expect_complete({{0, 40}}, 8, 32);
    expect_complete({{0, 7}, {16, 48}}, 4 + 2, 6 + 32);
    expect_complete({{0, 64}}, 4, 64);
    expect_complete({{0, 7}, {16, 80}}, 4, 64);
}

TEST(Batches, count_by_the_weights_of_their_passes) {
    FilmKey key;
    key.small_passes = 2;
    const auto passes = [&](const Ranges& ranges) {
        return complete_batches(key, set_of(ranges)).passes;
    };
    EXPECT_EQ(passes({{0, 3}}), 0.5);
    EXPECT_EQ(passes({{0, 32}}), 0.5 + 30);
    EXPECT_EQ(passes({{0, 64}}), 0.5 + 62);
    EXPECT_EQ(passes({{16, 80}}), 64);
}

TEST(Batches, groups_count_as_early_where_all_their_passes_are_there) {
    const PassSet passes = set_of({{0, 9}, {16, 20}});
    EXPECT_TRUE(is_early(passes, {0, 8}));
    EXPECT_FALSE(is_early(passes, {8, 12}));
    EXPECT_FALSE(is_early(passes, {16, 20}));
    EXPECT_FALSE(is_early(set_of({{0, 8}, {16, 80}}), {0, 8}));
}

TEST(Batches, end_where_errors_change) {
    std::vector<std::uint64_t> ends;
    for (std::uint64_t pass = 0; pass < 48; pass = ends.back())
        ends.push_back(next_batch_end(pass));
    EXPECT_EQ(ends, (std::vector<std::uint64_t>{1, 2, 4, 6, 8, 12, 16, 32, 48}));
    EXPECT_EQ(next_batch_end(21), 32U);
}

/// Of discs that shrink.
TEST(Batches, have_the_mean_area_of_their_passes) {
    FilmKey key;
    key.alpha = 0.5;
    EXPECT_EQ(area_of(key, {0, 1}), 1);
    EXPECT_NEAR(area_of(key, {0, 2}), (1 + 1.5 / 2) / 2, 1e-15);
    EXPECT_NEAR(area_of(key, {1, 2}), 1.5 / 2, 1e-15);
    double sum = 0;
    for (std::uint32_t pass = 112; pass < 128; ++pass) sum += std::pow(radius_factor(pass, 0.5), 2);
    EXPECT_NEAR(area_of(key, {112, 128}), sum / 16, 1e-14);
    key.small_passes = 2;
    const double third = 1.5 / 2 * 2.5 / 3;
    EXPECT_NEAR(area_of(key, {0, 3}), ((1 + 1.5 / 2) / 4 + third) / (1 + 2.0 / 4), 1e-15);
}

}  // namespace
}  // namespace sunfleck::engine
