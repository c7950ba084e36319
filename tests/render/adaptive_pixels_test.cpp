// Camera paths where pixels are noisy: the numbers, what they are learned from, the same light.
#include "planning/adaptive_pixels.h"

#include "core/parallel.h"
#include "support/picture_spread.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSide = 32;
constexpr std::size_t kPixels = std::size_t{kSide} * kSide;
const PixelWindow kWindow{0, 0, kSide, kSide};

constexpr VarianceDecay kByChance{0.5};

/// Trials of so much noise in all pixels, and as many rays.
PixelTrials trials_of(const PixelWindow& window, double variance, double rays,
                      const VarianceDecay& law = kByChance) {
    PixelTrials trials = no_trials(window);
    trials.nets.assign(trials.nets.size(), law);
    trials.variance.fill(PixelValues(window.pixels(), variance));
    trials.rays.assign(window.pixels(), rays);
    return trials;
}

/// Noise in columns 8 to 11 alone, where paths need so many rays.
PixelTrials stripe(double variance, double rays, const VarianceDecay& law = kByChance) {
    PixelTrials trials = trials_of(kWindow, 0, 1, law);
    for (std::size_t i = 0; i < kPixels; ++i) {
        if (i % kSide / 4 != 2) continue;
        trials.variance[0][i] = trials.variance[1][i] = variance;
        trials.rays[i] = rays;
    }
    return trials;
}

std::vector<CameraShares> shares_of(const PixelWindow& window, const PixelTrials& trials,
                                    const PixelValues& light) {
    return camera_shares(window, trials, light, Objective::relative);
}

// The stripe is an eighth of the pixels, its noise eight times the mean: levels 1/8 to 8 give it 1
// to 64 paths, and 16 no more.
TEST(AdaptivePixels, get_paths_in_proportion_to_their_noise) {
    const PixelTrials trials = stripe(9, 1);
    const auto all = shares_of(kWindow, trials, PixelValues(kPixels, 5));
    constexpr std::array<std::uint32_t, 8> kPaths = {1, 2, 4, 8, 16, 32, 64, 64};
    ASSERT_EQ(all.size(), kPaths.size());
    for (std::size_t level = 0; level < all.size(); ++level) {
        for (std::size_t i = 0; i < kPixels; ++i)
            EXPECT_EQ(1U << all[level].log2_samples[i],
                      trials.variance[0][i] > 0 ? kPaths.at(level) : 1U);
        EXPECT_NEAR(all[level].work, 1 + (kPaths.at(level) - 1) / 8.0, 1e-12);
    }
}

// 3000 x 2000 pixels have six million paths with one each.
TEST(AdaptivePixels, have_no_more_paths_than_there_is_memory_for) {
    const PixelWindow window{0, 0, 3000, 2000};
    PixelTrials trials = trials_of(window, 1, 1);
    for (std::size_t i = 0; i < window.pixels(); i += 8)
        trials.variance[0][i] = trials.variance[1][i] = 9;
    const auto all = shares_of(window, trials, PixelValues(window.pixels(), 1));
    ASSERT_FALSE(all.empty());
    EXPECT_LT(all.back().work * static_cast<double>(window.pixels()), 0x1p23);
    EXPECT_GT(all.back().work, 1);
    EXPECT_LT(all.size(), 8U);
}

// Four paths of a pixel leave an eighth of its variance, where by chance they would leave a
// quarter.
TEST(AdaptivePixels, need_fewer_paths_where_nets_serve_them_better) {
    const VarianceDecay smooth{0.354};
    const auto paths = [&](const VarianceDecay& law, std::size_t level) {
        const auto all = shares_of(kWindow, stripe(9, 1, law), PixelValues(kPixels, 5));
        return 1U << all.at(level).log2_samples[9];
    };
    EXPECT_EQ(paths(smooth, 1), paths(kByChance, 1)) << "the first paths are worth more";
    EXPECT_EQ(paths(smooth, 5), 16U);
    EXPECT_EQ(paths(kByChance, 5), 32U);
}

// Relative errors: one stripe is twice as bright and has four times the variance, but for the share
// of the picture's brightness.
TEST(AdaptivePixels, count_by_noise_over_brightness_and_the_root_of_rays) {
    PixelTrials trials = stripe(1, 1);
    PixelValues light(kPixels, 1);
    const auto in_column = [](std::size_t i, std::size_t first) {
        return i % kSide >= first && i % kSide < first + 4;
    };
    for (std::size_t i = 0; i < kPixels; ++i) {
        if (in_column(i, 20)) trials.variance[0][i] = trials.variance[1][i] = 4;
        if (in_column(i, 16) || in_column(i, 20)) light[i] = 2;  // blocks of eight pixels
        if (!in_column(i, 26)) continue;
        trials.rays[i] = trials.variance[0][i] = 16;
        trials.variance[1][i] = 16;
    }
    const CameraShares shares = shares_of(kWindow, trials, light).at(3);
    EXPECT_EQ(shares.log2_samples[9], shares.log2_samples[22]);
    EXPECT_EQ(shares.log2_samples[9], shares.log2_samples[28]);
    EXPECT_GT(shares.log2_samples[9], 0);
    EXPECT_EQ(shares.log2_samples[2], 0);
}

TEST(AdaptivePixels, have_no_shares_where_nothing_is_noisy_or_bright) {
    const PixelValues light(kPixels, 1);
    EXPECT_FALSE(stripe(0, 1).have_noise());
    EXPECT_TRUE(shares_of(kWindow, stripe(0, 1), light).empty());
    EXPECT_TRUE(shares_of(kWindow, stripe(1, 1), PixelValues(kPixels, 0)).empty());
}

TEST(AdaptivePixels, leave_a_share_of_the_variance) {
    const PixelTrials trials = stripe(9, 1);
    Log2Samples half(kPixels, 0);
    for (std::size_t i = 0; i < kPixels; ++i) half[i] = i % kSide < 10 ? 3 : 0;  // of the stripe
    const CameraShares shares{half, 1, {half, half}};
    const BlockGrid grid(kSide, kSide, 16);
    EXPECT_NEAR(remaining_variance({}, trials, grid, 0), 9 / 4.0, 1e-12);
    EXPECT_NEAR(remaining_variance(shares, trials, grid, 0), 9 / 4.0 * (1 + 0.125) / 2, 1e-12);
    EXPECT_EQ(remaining_variance(shares, trials, grid, 1), 0) << "without noise";
}

// Noise that each half has seen elsewhere is none that more paths are known to take away.
TEST(AdaptivePixels, are_not_foretold_with_hindsight) {
    PixelTrials flashes = stripe(9, 1);
    for (std::size_t i = 0; i < kPixels; ++i)
        flashes.variance[i % 2][i] = i % kSide < 16 ? 1e-6 : 0;
    const CameraShares shares = shares_of(kWindow, flashes, PixelValues(kPixels, 5)).at(5);
    EXPECT_GT(shares.by_half[0][9], shares.by_half[1][9]);
    const BlockGrid grid(kSide, kSide, 16);
    EXPECT_GT(remaining_variance(shares, flashes, grid, 0),
              0.9 * remaining_variance({}, flashes, grid, 0));
}

TEST(AdaptivePixels, have_a_mean_number_of_paths) {
    EXPECT_DOUBLE_EQ(mean_paths({0, 1, 4}, {5, 3, 2}), (5 + 2 * 3 + 16 * 2) / 10.0);
    EXPECT_EQ(mean_paths({1, 1}, {0, 0}), 1) << "of nothing";
}

/// Of a pixel, on average over a part of the picture.
double paths_in(const Epoch& epoch, int side, int x0, int y0, int x1, int y1) {
    double sum = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            sum += 1U << epoch.log2_samples.at(static_cast<std::size_t>(y * side + x));
    return sum / ((x1 - x0) * (y1 - y0));
}

/// A disc that glows before nothing, and a grey wall below it.
Scene glowing_disc(int side) {
    return scene_of(view("0 0 4  0 0 0  0 1 0", 40, side) +
                    "AttributeBegin\nTranslate 0 .6 0\n"
                    "AreaLightSource \"diffuse\" \"rgb L\" [50 50 50] \"bool twosided\" true\n"
                    "Shape \"disk\" \"float radius\" .5\nAttributeEnd\n"
                    "LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 -1 3]\n" +
                    diffuse("0.5 0.5 0.5") + quad("-2 -2 -.1  2 -2 -.1  2 0 -.1  -2 0 -.1"));
}

// Its rim is all the noise that camera paths make without photons.
TEST(AdaptivePixels, are_found_at_the_rim_of_a_lamp) {
    constexpr int kHere = 48;
    const Scene scene = glowing_disc(kHere);
    int found = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        RenderSettings settings;
        settings.seed = seed;
        const Epoch epoch = learn_epoch(scene, settings, 16);
        if (epoch.log2_samples.empty()) continue;
        ++found;
        EXPECT_GT(paths_in(epoch, kHere, 14, 4, 34, 26), 1.5);
        EXPECT_EQ(paths_in(epoch, kHere, 22, 12, 26, 16), 1) << "within";
        EXPECT_EQ(paths_in(epoch, kHere, 0, 0, 8, 4), 1) << "beside it";
    }
    EXPECT_GE(found, 7) << "31 of 32 seeds find it";
}

TEST(AdaptivePixels, are_the_same_for_any_number_of_threads_in_all_of_an_epoch) {
    const Scene scene = glowing_disc(24);
    const std::vector<std::uint8_t> first = learn_epoch(scene, {}, 16).log2_samples;
    for (const std::size_t threads : {1U, 3U}) {
        const ThreadLimit limit(threads);
        EXPECT_EQ(learn_epoch(scene, {}, 77).log2_samples, first);
    }
}

TEST(AdaptivePixels, are_looked_for_in_the_first_epoch_too) {
    const Scene scene = glowing_disc(48);
    const Log2Samples first = learn_epoch(scene, {}, 0).log2_samples;
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(learn_epoch(scene, {}, 15).log2_samples, first);
}

TEST(AdaptivePixels, are_like_others_where_the_user_says_so) {
    const Scene scene = glowing_disc(24);
    for (const std::uint32_t pass : {0U, 16U}) {
        RenderSettings settings;
        settings.photon.adaptive_pixels = false;
        EXPECT_TRUE(learn_epoch(scene, settings, pass).log2_samples.empty());
        settings.photon.adaptive_pixels = true;
        settings.photon.sampler = PhotonSampler::uniform;
        EXPECT_TRUE(learn_epoch(scene, settings, pass).log2_samples.empty());
    }
}

// 256 passes at 16 x 16 pixels: the mean is known to .1%; a variance of 4 paths a pixel that is not
// a quarter or, by nets, less would be seen.
TEST(AdaptivePixels, have_the_same_light_with_less_noise) {
    const Scene scene = glowing_disc(16);
    RenderSettings settings;
    settings.photon.paths_per_pass = 100;
    Epoch epoch = learn_epoch(scene, settings, 128);
    epoch.log2_samples.clear();
    constexpr Pictures kBatches{128, 16, kBatchPasses};
    const PictureSpread even = spread_of(scene, settings, epoch, kBatches);
    epoch.log2_samples.assign(256, 0);
    for (std::size_t i = 0; i < 256; ++i) epoch.log2_samples[i] = i % 2 == 0 ? 2 : 3;
    const PictureSpread more = spread_of(scene, settings, epoch, kBatches);
    EXPECT_NEAR(more.mean / even.mean, 1, 0.004);
    EXPECT_LT(more.variance / even.variance, 0.25);
}

}  // namespace
}  // namespace sunfleck::engine
