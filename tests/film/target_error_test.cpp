// The target error: a quantile of noise, and the root mean square of a bias less its own noise.
#include "film/target_error.h"

#include "film/bias.h"
#include "lines.h"
#include "math/statistics.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::film_by_batch;
using testing_support::Line;
using testing_support::line_film;
using testing_support::line_key;
using testing_support::numbers;

TEST(TargetError, needs_four_batches) {
    const FilmKey key = testing_support::small_key();
    EXPECT_FALSE(target_error(testing_support::film_of(key, numbers(0, 5)), {}).has_value());
    EXPECT_TRUE(target_error(testing_support::film_of(key, numbers(0, 6)), {}).has_value());
    EXPECT_FALSE(target_error(testing_support::film_of(key, numbers(16, 79)), {}).has_value());
}

/// 40 bright blocks whose relative error rises from 1 to 40 steps; 10 dark ones of wild error.
Film film_of_steps() {
    return film_by_batch(400, 8, 64, [](std::uint32_t batch, std::size_t pixel) {
        const std::size_t block = pixel % 400 / 8;
        const float sign = batch % 2 == 0 ? 1.0F : -1.0F;
        if (block >= 40) return 1e-4F * (1 + sign);
        return 1 + sign * 0.01F * static_cast<float>(block + 1);
    });
}

TEST(TargetError, of_noise_is_the_95th_percentile_of_bright_blocks) {
    const Film film = film_of_steps();
    // Four batches of 1 +- d: standard error d / sqrt(3), widened for three degrees of freedom. 38
    // of 40 blocks are at or below the 38th.
    EXPECT_NEAR(target_error(film, {})->noise, 1.6534 * 0.38 / std::sqrt(3.0), 1e-4);
    EXPECT_EQ(target_error(film, {})->bias, 0);  // no discs
    EXPECT_FALSE(relative_bias(film));
    const Film black = film_by_batch(8, 8, 64, [](std::uint32_t, std::size_t) { return 0.0F; });
    EXPECT_FALSE(target_error(black, {}).has_value());
}

/// Blocks of a twentieth of the light, with an error of half of it.
TEST(TargetError, of_dark_blocks_is_told_apart) {
    const Film film = film_by_batch(400, 8, 64, [](std::uint32_t batch, std::size_t pixel) {
        const float sign = batch % 2 == 0 ? 1.0F : -1.0F;
        return pixel % 400 / 8 < 40 ? 1 + sign * 0.01F : 0.05F * (1 + sign * 0.5F);
    });
    const auto error = target_error(film, {});
    EXPECT_NEAR(error->noise, 1.6534 * 0.01 / std::sqrt(3.0), 1e-4);
    EXPECT_NEAR(error->of_dark.value_or(0), 1.6534 * 0.5 / std::sqrt(3.0), 1e-3);
    EXPECT_FALSE(target_error(film_of_steps(), {})->of_dark) << "too dark to be told";
}

/// 48 of all 50 blocks are at or below the 38th bright one, and the picture's brightness is .8.
TEST(TargetError, of_an_absolute_objective_is_over_the_brightness_of_the_picture) {
    ErrorTerms terms;
    terms.objective = Objective::absolute;
    EXPECT_NEAR(target_error(film_of_steps(), terms)->noise, 1.6534 * 0.38 / std::sqrt(3.0) / 0.8,
                1e-3);
}

TEST(TargetError, without_noise_is_nothing) {
    const Film film = film_by_batch(3, 2, 64, [](std::uint32_t, std::size_t) { return 0.1F; });
    EXPECT_LT(target_error(film, {})->value(), 1e-7);
}

TEST(TargetError, joins_noise_and_bias) {
    EXPECT_NEAR((TargetError{0.03, 0.04}.value()), 0.05, 1e-15);
    // Blocks of slopes 0, 1 and 2 over 4, and a dark one of a large relative slope.
    const auto line = [](std::size_t pixel) {
        const std::size_t block = pixel % 32 / 8;
        if (block == 3) return Line{1e-4, 1e-3, 0};
        return Line{4, static_cast<double>(block), 0};
    };
    const Film film = line_film(line_key(32, 8, 1), numbers(0, 64), line);
    const auto areas = disc_areas(film);
    double squares = 0;
    for (const double slope : {0, 1, 2}) {
        const double bias = slope * areas->mean;
        squares += std::pow(bias / (4 + bias), 2) / 3;
    }
    // The lines have no noise; what batches differ by is their slope.
    EXPECT_NEAR(*relative_bias(film), std::sqrt(squares), 1e-5);
    EXPECT_NEAR(target_error(film, {})->bias, std::sqrt(squares), 1e-5);
    EXPECT_EQ(target_error(film, {false, false})->bias, 0);
    EXPECT_EQ(target_error(film, {false, false})->noise, target_error(film, {})->noise);
    EXPECT_GT(target_error(film, {})->noise, 0.01);
    EXPECT_EQ(target_error(film, {true, true})->bias, 0);
    EXPECT_LT(target_error(film, {true, true})->noise, 1e-4);  // of the line's end
}

/// 16 blocks, a bias of 5.7% or none, each known to 3.3%: squares of estimates would be wrong by
/// .0011. Over 100 seeds; four standard errors are .0007 at most.
TEST(TargetError, square_of_the_bias_is_not_that_of_its_noise) {
    for (const double slope : {0.0, 0.2}) {
        RunningMean squares;
        RunningMean roots;
        double truth = 0;
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            const Film film = line_film(line_key(128, 8, seed), numbers(0, 80),
                                        [&](std::size_t) { return Line{1, slope, 0, 0.5, 0, 0}; });
            const double bias = slope * disc_areas(film)->mean_of_passes;
            truth = bias / (1 + bias);
            double square = 0;
            for (const Bias& b : block_biases(film))
                square += (b.value * b.value - b.standard_error * b.standard_error) / 16;
            squares.add(square / ((1 + bias) * (1 + bias)));
            roots.add(*relative_bias(film));
        }
        EXPECT_NEAR(squares.mean(), truth * truth, 4 * squares.standard_error());
        EXPECT_LT(squares.standard_error(), 1.7e-4);
        EXPECT_NEAR(roots.mean(), truth, 0.02) << slope;
    }
}

/// Noise alone: passes by the square of the error. Bias alone: to the power of 1 / (1 - alpha).
TEST(TargetError, says_how_many_times_the_passes_reach_it) {
    EXPECT_NEAR(times_passes_to({0.06, 0}, 0.02, 0.5), 9, 1e-6);
    EXPECT_NEAR(times_passes_to({0, 0.04}, 0.02, 2.0 / 3), 8, 1e-6);
    EXPECT_NEAR(times_passes_to({0, 0.04}, 0.02, 0.5), 4, 1e-6);
    EXPECT_NEAR(times_passes_to({0.01, 0.01}, 0.02, 0.5), 1, 1e-6);
    const double both = times_passes_to({0.06, 0.04}, 0.02, 0.5);
    EXPECT_NEAR(std::hypot(0.06, 0.04) / std::sqrt(both), 0.02, 1e-6);
}

/// Half the error takes three times the passes that there are.
TEST(TargetError, says_how_many_passes_are_left_of_a_film) {
    const Film film = film_by_batch(1, 1, 64, [](std::uint32_t, std::size_t) { return 1.0F; });
    EXPECT_NEAR(passes_left(film, {0.04, 0}, 0.02, 0.5), 3 * 64, 1e-4);
    EXPECT_NEAR(passes_left(film, {0.01, 0}, 0.02, 0.5), 0, 1e-4);
}

/// Or a render would end before the light is in any batch.
TEST(TargetError, is_not_known_where_complete_batches_are_black) {
    const Film film = film_by_batch(
        8, 8, 70, [](std::uint32_t batch, std::size_t) { return batch < 4 ? 0.0F : 1.0F; });
    EXPECT_EQ(film.batches().count, kTargetBatches);
    EXPECT_FALSE(target_error(film, {}).has_value());
}

}  // namespace
}  // namespace sunfleck::engine
