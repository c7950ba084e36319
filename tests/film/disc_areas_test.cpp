// Areas of a film's discs against sums over passes, and films from which no slope can be had.
#include "film/disc_areas.h"

#include "lines.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::line_film;
using testing_support::line_key;
using testing_support::numbers;

Film dark(const std::vector<std::uint32_t>& passes, double alpha = 2.0 / 3) {
    return line_film(line_key(1, 1, 1, alpha), passes,
                     [](std::size_t) { return testing_support::Line{}; });
}

double area(std::uint32_t pass) {
    return std::pow(radius_factor(pass, 2.0 / 3), 2);
}

/// Batches 0, 1, 3 to 5, and of 2 and 7 six passes and one, which count less in the picture: four
/// passes, two whose group is incomplete, and one.
TEST(DiscAreas, are_sums_over_batches_and_passes) {
    std::vector<std::uint32_t> passes = numbers(0, 36);
    for (const std::uint32_t pass : numbers(46, 96)) passes.push_back(pass);
    passes.push_back(112);
    const auto areas = disc_areas(dark(passes));
    ASSERT_TRUE(areas);
    double mean = 0;
    double squares = 0;
    for (const std::uint32_t batch : {0U, 1U, 3U, 4U, 5U}) {
        const double of_batch = area_of(line_key(1, 1, 1), batch_range(batch));
        mean += of_batch / 5;
        squares += of_batch * of_batch;
    }
    EXPECT_EQ(areas->complete.count, 5);
    EXPECT_NEAR(areas->mean, mean, 1e-14);
    EXPECT_NEAR(areas->squares, 16 * (squares - 5 * mean * mean), 1e-13);
    double of_picture = 0;
    double count = 0;
    for (const std::uint32_t pass : passes) {
        const double of_batch_2 = pass < 36 ? 1.0 / 4 : 0;
        const double share = pass / 16 == 2 ? of_batch_2 : pass / 16 == 7 ? 1.0 / 64 : 1;
        of_picture += share * area(pass);
        count += share;
    }
    EXPECT_NEAR(areas->mean_of_passes, of_picture / count, 1e-14);
}

/// Of passes 0 to 39: seven early batches, and a whole one.
TEST(DiscAreas, of_early_batches_count_as_often_as_these_have_passes) {
    const auto areas = disc_areas(dark(numbers(0, 40)));
    ASSERT_TRUE(areas);
    EXPECT_EQ(areas->complete.passes, 32);
    double mean = 0;
    double squares = 0;
    for (const PassRange& batch :
         {PassRange{0, 1}, {1, 2}, {2, 4}, {4, 6}, {6, 8}, {8, 12}, {12, 16}, {16, 32}}) {
        double of_batch = 0;
        for (std::uint64_t pass = batch.begin; pass < batch.end; ++pass)
            of_batch += area(static_cast<std::uint32_t>(pass)) / static_cast<double>(batch.size());
        mean += of_batch * static_cast<double>(batch.size()) / 32;
        squares += of_batch * of_batch * static_cast<double>(batch.size());
    }
    EXPECT_NEAR(areas->mean, mean, 1e-14);
    EXPECT_NEAR(areas->squares, squares - 32 * mean * mean, 1e-13);
    EXPECT_EQ(areas->divisor, 0) << "of pixels nothing is known";
}

TEST(DiscAreas, of_small_passes_count_a_quarter) {
    FilmKey key = line_key(1, 1, 1);
    key.small_passes = 2;
    const auto areas = disc_areas(
        line_film(key, numbers(0, 64), [](std::size_t) { return testing_support::Line{}; }));
    ASSERT_TRUE(areas);
    EXPECT_EQ(areas->complete.passes, 62.5);
    double sum = 0;
    for (std::uint32_t pass = 0; pass < 64; ++pass) sum += area(pass) * (pass < 2 ? 0.25 : 1);
    EXPECT_NEAR(areas->mean, sum / 62.5, 1e-14);
    EXPECT_NEAR(areas->mean_of_passes, sum / 62.5, 1e-14);
}

TEST(DiscAreas, need_four_complete_batches_and_discs) {
    EXPECT_FALSE(disc_areas(dark(numbers(0, 5))));
    EXPECT_TRUE(disc_areas(dark(numbers(0, 6))));
    EXPECT_FALSE(disc_areas(dark(numbers(16, 79))));
    FilmKey key = testing_support::small_key();
    key.alpha = 0;
    EXPECT_FALSE(disc_areas(testing_support::film_of(key, numbers(0, 64))));
    EXPECT_FALSE(disc_areas(Film(line_key(1, 1, 1))));
}

/// Over batches 0 to 3 a bias is known 3.4 times less well than a mean, over 4 to 7 19 times.
TEST(DiscAreas, need_radii_that_shrink) {
    const auto areas = disc_areas(dark(numbers(0, 64)));
    EXPECT_NEAR(std::sqrt(areas->bias_variance() * 64), 3.40, 0.01);
    EXPECT_FALSE(disc_areas(dark(numbers(64, 128))));
    EXPECT_FALSE(disc_areas(dark(numbers(0, 64), 0.95)));
}

}  // namespace
}  // namespace sunfleck::engine
