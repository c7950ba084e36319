// Biases and their errors against films whose light is a known line over the discs' areas.
//
// 400 seeds: the spread of an estimate is known to 3.5% (one sigma), so that an error wrong by a
// factor of 1.15 is seen, and a mean wrong by a fifth of its spread.
#include "film/bias.h"

#include "film/film_picture.h"
#include "film/target_error.h"
#include "lines.h"
#include "math/statistics.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::Line;
using testing_support::line_film;
using testing_support::line_key;
using testing_support::numbers;

/// Mean of the discs' areas over passes [0, end), each as often as it counts in the picture.
double mean_area(std::uint32_t end) {
    double sum = 0;
    double count = 0;
    for (std::uint32_t p = 0; p < end; ++p) {
        const std::uint32_t held = std::min(end - p / kBatchPasses * kBatchPasses, kBatchPasses);
        const double share = held / double{kBatchPasses};
        sum += share * std::pow(radius_factor(p, 2.0 / 3), 2);
        count += share;
    }
    return sum / count;
}

/// Pixel i has slope i / 10, cells of four pixels the mean of these, whatever batches are complete:
/// from all passes, to the last digits.
TEST(Bias, of_a_line_without_noise_is_found) {
    std::vector<std::uint32_t> passes = numbers(0, 73);
    for (const std::uint32_t pass : numbers(90, 141)) passes.push_back(pass);
    const auto line = [](std::size_t i) { return Line{1, static_cast<double>(i) / 10}; };
    FilmKey key = line_key(9, 9, 1);
    key.small_passes = 2;
    const Film film = line_film(key, passes, line);
    double area = 0;
    for (const std::uint32_t pass : passes)
        area += weight_of(key, pass) * film.share_of_pass(pass) *
                std::pow(radius_factor(pass, 2.0 / 3), 2) / film.passes_in_picture();
    const auto pixels = pixel_biases(film);
    ASSERT_EQ(pixels.size(), 81U);
    const BlockGrid cells = photon_cells_of(film.key());
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        const BlockGrid::Block of = cells.block(cell);
        const double middle =
            static_cast<double>(of.x_begin + of.x_end - 1 + 9 * (of.y_begin + of.y_end - 1)) / 2;
        cells.for_pixels(cell, [&](std::size_t i) {
            for (const double bias : pixels[i]) EXPECT_NEAR(bias, middle / 10 * area, 1e-5) << i;
        });
    }
    const auto blocks = block_biases(film);
    ASSERT_EQ(blocks.size(), 4U);
    EXPECT_NEAR(blocks[0].value, 3.5 * area, 1e-5);  // pixels 0 to 7, 9 to 16, ... 63 to 70
    EXPECT_NEAR(blocks[3].value, 8 * area, 1e-5);
    EXPECT_NEAR(image_bias(film)->value, 4 * area, 1e-5);
    EXPECT_LT(image_bias(film)->standard_error, 1e-4);
    EXPECT_LT(extrapolated_block_errors(film)[0], 1e-4);
    EXPECT_LT(extrapolated_pixel_errors(film)[80], 1e-4);
}

/// From early batches that of blocks and of the picture is known, whatever open ones hold.
TEST(Bias, of_a_line_without_noise_is_found_early) {
    FilmKey key = line_key(9, 9, 1);
    key.small_passes = 2;
    for (const std::uint32_t passes : {6U, 8U, 11U, 16U, 41U, 63U}) {
        const Film film = line_film(key, numbers(0, passes), [](std::size_t i) {
            return Line{1, static_cast<double>(i) / 10};
        });
        const auto areas = disc_areas(film);
        ASSERT_TRUE(areas);
        const auto blocks = block_biases(film);
        ASSERT_EQ(blocks.size(), 4U);
        EXPECT_NEAR(blocks[0].value, 3.5 * areas->mean_of_passes, 1e-5) << passes;
        EXPECT_NEAR(image_bias(film)->value, 4 * areas->mean_of_passes, 1e-5) << passes;
        EXPECT_LT(image_bias(film)->standard_error, 1e-4) << passes;
        EXPECT_TRUE(pixel_biases(film).empty());
    }
}

TEST(Bias, is_not_known_from_too_few_batches) {
    for (const auto& passes : {numbers(0, 5), numbers(16, 79)}) {
        const Film film = testing_support::film_of(testing_support::small_key(), passes);
        EXPECT_TRUE(pixel_biases(film).empty());
        EXPECT_TRUE(block_biases(film).empty());
        EXPECT_FALSE(image_bias(film));
        EXPECT_TRUE(extrapolated_pixel_errors(film).empty());
        EXPECT_TRUE(extrapolated_block_errors(film).empty());
    }
}

TEST(Bias, is_not_known_where_photons_have_lit_an_open_batch_alone) {
    FilmKey key{3, 2, {}, 1, 0, ""};
    key.alpha = 0.5;
    for (const bool is_lit : {false, true}) {
        Film film(key);
        for (const std::uint32_t pass : numbers(0, 70)) {
            PassImage image(6, {}, photon_cells_of(key));
            if (is_lit && pass > 64) image.add_light(0, Vec3(1), Aov::caustic);
            film.add_pass(pass, image);
        }
        EXPECT_EQ(image_bias(film).has_value(), !is_lit) << "black: no bias";
        EXPECT_FALSE(target_error(film, {}).has_value());
    }
}

/// Estimates of one number over seeds.
struct Estimates {
    RunningMean values;
    RunningMean variances;  // as claimed
    int covered = 0;        // by intervals of 95%

    /// @param quantile  of Student's t, two-sided, 95%.
    void add(const Bias& seen, double truth, double quantile) {
        values.add(seen.value);
        variances.add(seen.standard_error * seen.standard_error);
        covered += std::abs(seen.value - truth) < quantile * seen.standard_error ? 1 : 0;
    }
    /// Claimed standard error over the true one.
    double ratio() const { return std::sqrt(variances.mean() / values.variance()); }
};

constexpr std::uint32_t kSeeds = 400;
constexpr std::uint32_t kPasses = 133;  // eight batches and five passes
constexpr double kQuantile = 2.447;     // of t with six degrees of freedom

/// The picture's luminance less its bias.
double extrapolated(const Film& film, std::size_t pixel) {
    return double{film_picture(film).find("R")->values[pixel]} - pixel_biases(film)[pixel][0];
}

class NoisyLines : public testing::Test {
protected:
    /// Films of 12 x 8 pixels: blocks of 64 and of 32.
    explicit NoisyLines(const Line& line) {
        const double truth = line.c * mean_area(kPasses);
        for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
            const Film film = line_film(line_key(12, 8, seed), numbers(0, kPasses),
                                        [&](std::size_t) { return line; });
            const auto biases = block_biases(film);
            block_.add(biases[0], truth, kQuantile);
            image_.add(*image_bias(film), truth, kQuantile);
            const auto errors = extrapolated_pixel_errors(film);
            for (std::size_t i = 0; i < 96; i += 5)
                pixels_.at(i / 5).add({extrapolated(film, i), errors[i]}, line.a + line.eye,
                                      kQuantile);
            const MeanError block = block_errors(film)[0];
            block_without_.add({block.mean - biases[0].value, extrapolated_block_errors(film)[0]},
                               line.a + line.eye, kQuantile);
        }
        truth_ = truth;
    }

    /// Claimed over true standard error of extrapolated pixels.
    double pixel_ratio() const {
        double claimed = 0;
        double truth = 0;
        for (const Estimates& pixel : pixels_) {
            claimed += pixel.variances.mean();
            truth += pixel.values.variance();
        }
        return std::sqrt(claimed / truth);
    }

    void expect_all_is_true() const {
        EXPECT_NEAR(block_.values.mean(), truth_, 4 * block_.values.standard_error());
        EXPECT_NEAR(image_.values.mean(), truth_, 4 * image_.values.standard_error());
        EXPECT_LT(block_.values.standard_error(), 0.02 * truth_) << "or nothing would be seen";
        EXPECT_NEAR(block_.ratio(), 1, 0.15);
        EXPECT_NEAR(image_.ratio(), 1, 0.15);
        // 95% of 400 is 380; 4 standard errors are 17.
        EXPECT_NEAR(block_.covered, 380, 17);
        EXPECT_NEAR(image_.covered, 380, 17);
        EXPECT_NEAR(block_without_.ratio(), 1, 0.15);
        EXPECT_NEAR(pixel_ratio(), 1, 0.15);
        for (const Estimates& pixel : pixels_)
            EXPECT_NEAR(pixel.values.mean(), 1.5, 4 * pixel.values.standard_error());
    }

    double truth_ = 0;
    Estimates block_;
    Estimates image_;
    Estimates block_without_;
    std::array<Estimates, 20> pixels_;
};

class NoisyPhotons : public NoisyLines {
protected:
    NoisyPhotons() : NoisyLines({1, 0.8, 0.5, 0.3, 0.05, 0}) {}
};

class NoisyCameraPaths : public NoisyLines {
protected:
    NoisyCameraPaths() : NoisyLines({1, 0.8, 0.5, 0.3, 0.05, 1}) {}
};

TEST_F(NoisyPhotons, bias_is_unbiased_and_its_error_is_true) {
    expect_all_is_true();
}

/// Noise of camera paths, three times that of photons, is in the picture's error and in no slope.
TEST_F(NoisyCameraPaths, leave_the_bias_alone) {
    EXPECT_NEAR(block_.values.mean(), truth_, 4 * block_.values.standard_error());
    EXPECT_LT(block_.values.standard_error(), 0.02 * truth_);
    EXPECT_NEAR(block_.ratio(), 1, 0.15);
    EXPECT_NEAR(block_without_.ratio(), 1, 0.15);
    EXPECT_GT(pixel_ratio(), 1);  // bias.h: not less than it is
}

}  // namespace
}  // namespace sunfleck::engine
