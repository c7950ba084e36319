// Error bars against the true spread over 400 renders of synthetic noise.
//
// The noise of a pass: stratified within its batch (so that passes are not independent and errors
// taken from them would be wrong), times a brightness that all pixels share. Seeds 0 to 399; the
// spread over 400 is itself known to 3.5% (one sigma), so that an error bar wrong by a factor of
// 1.1 or more is seen at 10% tolerance for what is averaged over many pixels or blocks.
#include "film/error_bars.h"

#include "film/film_picture.h"
#include "math/statistics.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::film_by_batch;
using testing_support::film_by_pass;

constexpr std::uint32_t kSeeds = 400;
constexpr std::uint32_t kPasses = 101;  // six batches and five passes
constexpr int kWidth = 12;              // blocks of 8 x 8 and of 4 x 8 pixels
constexpr int kHeight = 8;

/// Pixel i of a pass has expectation 1 + i % 3.
Film noisy_film(std::uint64_t seed) {
    const FilmKey key{kWidth, kHeight, {}, seed, 0, ""};
    Film film(key);
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
        RandomStream shared(seed, Purpose::test, pass, 0xFFFF);
        const float brightness = 0.8F + 0.4F * shared.next_float();
        PassImage image(key.pixels(), key.aovs);
        for (std::uint32_t i = 0; i < key.pixels(); ++i) {
            RandomStream shift(seed, Purpose::test, pass / kBatchPasses, 0x10000 + i);
            const auto stratum = static_cast<float>(pass % kBatchPasses) / kBatchPasses;
            float u = stratum + shift.next_float();
            if (u >= 1) u -= 1;
            RandomStream own(seed, Purpose::test, pass, i);
            const auto level = static_cast<float>(1 + i % 3);
            const float value = level * brightness * (u + own.next_float());
            image.add_light(i, Vec3(value, value, value), Aov::direct);
        }
        film.add_pass(pass, image);
    }
    return film;
}

/// The true spread of some means beside what their error bars said.
struct Spread {
    std::vector<RunningMean> means;
    RunningMean variances;  // as claimed, over all quantities and seeds

    void add(const std::vector<MeanError>& errors) {
        means.resize(errors.size());
        for (std::size_t i = 0; i < errors.size(); ++i) {
            means[i].add(errors[i].mean);
            variances.add(errors[i].standard_error * errors[i].standard_error);
        }
    }
    /// Claimed standard error over the true one.
    double ratio() const {
        double truth = 0;
        for (const RunningMean& mean : means) truth += mean.variance();
        return std::sqrt(variances.mean() * static_cast<double>(means.size()) / truth);
    }
};

TEST(ErrorBars, agree_with_the_spread_over_seeds) {
    Spread pixels;
    Spread blocks;
    Spread image;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Film film = noisy_film(seed);
        pixels.add(pixel_errors(film));
        blocks.add(block_errors(film));
        image.add({*image_error(film)});
    }
    EXPECT_EQ(blocks.means.size(), 2U);
    EXPECT_NEAR(pixels.ratio(), 1, 0.1);
    EXPECT_NEAR(blocks.ratio(), 1, 0.1);
    EXPECT_NEAR(image.ratio(), 1, 0.1);
    EXPECT_NEAR(image.means[0].mean(), 2, 4 * image.means[0].standard_error());
    // The shared brightness is in the error of the picture: pixels alone would average it away.
    EXPECT_GT(image.means[0].variance(), 1e-4);
}

TEST(ErrorBars, need_complete_batches) {
    const FilmKey key = testing_support::small_key();
    Film film = testing_support::film_of(key, testing_support::numbers(16, 47));
    EXPECT_TRUE(pixel_errors(film).empty());
    EXPECT_TRUE(block_errors(film).empty());
    EXPECT_FALSE(image_error(film).has_value());
    merge(film, testing_support::film_of(key, testing_support::numbers(47, 63)));
    EXPECT_EQ(pixel_errors(film).size(), key.pixels());
    EXPECT_EQ(block_errors(film).size(), 6U);
}

TEST(ErrorBars, are_known_from_two_passes_on) {
    const auto value = [](std::uint32_t pass, std::size_t) {
        return 1.0F + 2.0F * static_cast<float>(pass);
    };
    EXPECT_TRUE(pixel_errors(film_by_pass(3, 2, 1, value)).empty());
    // Passes of 1 and 3, and an open batch that must not count.
    const Film film = film_by_pass(3, 2, 3, value);
    EXPECT_NEAR(pixel_errors(film)[4].mean, 2, 1e-12);
    EXPECT_NEAR(pixel_errors(film)[4].standard_error, 1, 1e-12);
    EXPECT_NEAR(block_errors(film)[0].standard_error, 1, 1e-12);
    EXPECT_NEAR(image_error(film)->standard_error, 1, 1e-12);
}

TEST(ErrorBars, two_whole_batches_by_hand) {
    // Seven early batches of 1, a whole one of 3, and an open one of 100 that must not count:
    // the mean is 2, a pass has a variance of 32 / 7, and there are 32 of them.
    const Film film = film_by_batch(3, 2, 37, [](std::uint32_t batch, std::size_t) {
        return batch == 0 ? 1.0F : batch == 1 ? 3.0F : 100.0F;
    });
    const double error = std::sqrt(1.0 / 7);
    EXPECT_NEAR(pixel_errors(film)[4].mean, 2, 1e-12);
    EXPECT_NEAR(pixel_errors(film)[4].standard_error, error, 1e-12);
    EXPECT_NEAR(block_errors(film)[0].mean, 2, 1e-12);
    EXPECT_NEAR(block_errors(film)[0].standard_error, error, 1e-12);
    EXPECT_NEAR(image_error(film)->standard_error, error, 1e-12);
    EXPECT_NEAR(image_mean(film), (16 * 1 + 16 * 3 + 4 * 0.25 * 100) / (32 + 4 * 0.25), 1e-12);
}

TEST(ErrorBars, of_a_pixel_that_only_an_open_batch_has_lit_is_its_light) {
    const Film film = film_by_batch(3, 2, 37, [](std::uint32_t batch, std::size_t pixel) {
        return batch == 2 && pixel == 4 ? 100.0F : 0.0F;
    });
    EXPECT_EQ(pixel_errors(film)[4].mean, 0);
    EXPECT_NEAR(pixel_errors(film)[4].standard_error, 5 * 100 / 37.0, 1e-9);
    EXPECT_EQ(pixel_errors(film)[3].standard_error, 0);
    // As of a complete batch among black ones.
    const Film complete = film_by_batch(3, 2, 64, [](std::uint32_t batch, std::size_t pixel) {
        return batch == 2 && pixel == 4 ? 100.0F : 0.0F;
    });
    EXPECT_NEAR(pixel_errors(complete)[4].standard_error, 16 * 100 / 64.0, 1e-9);
}

/// The first batch has four times the variance of the others, as before the first plan.
TEST(ErrorBars, hold_where_batches_differ_in_variance) {
    Spread pixels;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed)
        pixels.add(pixel_errors(
            film_by_batch(8, 8, 8 * kBatchPasses, [&](std::uint32_t batch, std::size_t i) {
                RandomStream random(seed, Purpose::test, batch, static_cast<std::uint32_t>(i));
                const float noise = random.next_float() - 0.5F;
                return 1 + (batch > 0 ? noise / 2 : noise);
            })));
    EXPECT_NEAR(pixels.ratio(), 1, 0.02);
}

FilmKey key_of(int width, int height, bool starts_small) {
    FilmKey key{width, height, {}, 1, 0, ""};
    key.small_passes = starts_small ? kSmallPasses : 0;
    return key;
}

/// Normal noise of a pass's pixel, by Box and Muller.
float normal_noise(std::uint32_t pass, std::size_t pixel) {
    RandomStream random(17, Purpose::test, pass, static_cast<std::uint32_t>(pixel));
    const float size = std::sqrt(-2 * std::log(1 - random.next_float()));
    return size * std::cos(6.2831853F * random.next_float());
}

/// Share of 1024 pixels of normal noise whose true value, 10, lies within two errors as films
/// report them. Known to .65% (one sigma); without Student's t it is 70, 82, 86 and 91% of 2, 3, 4
/// and 8 batches. @param noise_of_others  than the first 16 passes.
double covered(std::uint32_t passes, float noise_of_others, bool starts_small = false) {
    const FilmKey key = key_of(32, 32, starts_small);
    const Film film = film_by_pass(key, passes, [&](std::uint32_t pass, std::size_t pixel) {
        const double scale = 1 / std::sqrt(weight_of(key, pass));
        const float noise = static_cast<float>(scale) * normal_noise(pass, pixel);
        return 10 + (pass < kBatchPasses ? 1 : noise_of_others) * noise;
    });
    const auto means = pixel_errors(film);
    const std::vector<float> errors = film_picture(film).find("error.Y")->values;
    double inside = 0;
    for (std::size_t i = 0; i < means.size(); ++i)
        inside += std::abs(means[i].mean - 10) < 2 * double{errors[i]} ? 1 : 0;
    return inside / static_cast<double>(means.size());
}

TEST(ErrorBars, as_reported_hold_the_truth_as_often_for_few_batches_as_for_many) {
    for (const std::uint32_t passes : {2U, 3U, 4U, 8U, 13U, 16U, 32U, 48U, 64U, 128U}) {
        EXPECT_NEAR(covered(passes, 1), 0.9545, 0.022) << passes;
        EXPECT_NEAR(covered(passes, 1, true), 0.9545, 0.022) << passes << ", the first two small";
    }
}

/// Variances of 4, 1, 1 ...: intervals are a little too wide, 96% of them hold the truth. Those
/// with early batches are as much too narrow as the first passes have more noise than the others.
TEST(ErrorBars, as_reported_hold_the_truth_where_batches_differ_in_variance) {
    for (const std::uint32_t passes : {64U, 128U})
        EXPECT_NEAR(covered(passes, 0.5F), 0.962, 0.022) << passes;
    for (const std::uint32_t passes : {32U, 48U})
        EXPECT_NEAR(covered(passes, 0.5F), 0.9545, 0.05) << passes;
}

TEST(ErrorBars, have_a_degree_of_freedom_less_than_batches) {
    const auto grey = [](std::uint32_t, std::size_t) { return 1.0F; };
    EXPECT_EQ(error_degrees(film_by_batch(1, 1, 5 * kBatchPasses + 3, grey)), 4);
}

/// An error of zero would say that the light is known.
TEST(ErrorBars, of_light_in_an_open_batch_alone_are_not_known) {
    for (const std::uint32_t lit : {2U, 9U}) {
        const Film film = film_by_batch(
            3, 2, 37, [&](std::uint32_t batch, std::size_t) { return batch < lit ? 0.0F : 1.0F; });
        EXPECT_EQ(image_error(film).has_value(), lit == 9) << "but that of a black picture is";
        EXPECT_NEAR(image_mean(film), lit == 9 ? 0 : 1 / 33.0, 1e-12);
    }
}

TEST(ErrorBars, equal_batches_have_no_error) {
    const Film film = film_by_batch(3, 2, 64, [](std::uint32_t, std::size_t) { return 0.1F; });
    EXPECT_LT(pixel_errors(film)[0].standard_error, 1e-8);
}

}  // namespace
}  // namespace sunfleck::engine
