// Variances of trial passes whose noise is known.
#include "planning/trial_variance.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kSize = 64;
constexpr std::size_t kPixels = std::size_t{kSize} * kSize;
const PixelWindow kWindow{0, 0, kSize, kSize};

/// Variances of a pixel, of uniform noise.
struct Noise {
    double unlit = 0;   // of camera paths, where light needs no photon
    double lit = 0;     // of camera paths, in light of photons
    double shared = 0;  // of a set of photons, the same in both views
    double own = 0;     // of a set of photons, of each view's own
};

/// Of light that needs no photon, of brightness 1, and the rest of brightness `mean`.
TrialPair pair_of(double mean, const Noise& noise) {
    TrialPair pair;
    pair.paths = 1000;
    for (std::size_t i = 0; i < kPixels; ++i) {
        RandomStream random(5, Purpose::test, 0, static_cast<std::uint32_t>(i));
        const auto of = [&](double variance) {
            return (2 * random.next() - 1) * std::sqrt(3 * variance);
        };
        const std::array<double, 2> shared = {of(noise.shared), of(noise.shared)};
        for (Trial* view : {&pair.one, &pair.other}) {
            view->camera.push_back(1 + of(noise.unlit));
            const double light = view->camera.back() + mean - 1 + of(noise.lit);
            for (const std::size_t set : {0U, 1U})
                view->lit.at(set).push_back(light + shared.at(set) + of(noise.own));
        }
    }
    return pair;
}

/// One path each, by chance and with a batch's gain left out.
PixelTrials by_chance() {
    PixelTrials trials = no_trials(kWindow);
    trials.nets.assign(trials.nets.size(), {0.5});
    return trials;
}

CameraShares four_each() {
    CameraShares shares{Log2Samples(kPixels, 2), 4, {}};
    shares.by_half.fill(shares.log2_samples);
    return shares;
}

BlockVariance mean_of(const std::vector<BlockVariance>& blocks) {
    BlockVariance mean;
    for (const BlockVariance& b : blocks) {
        mean.camera += b.camera / static_cast<double>(blocks.size());
        mean.photon += b.photon / static_cast<double>(blocks.size());
    }
    return mean;
}

BlockVariance measured(const TrialPair& pair, const PixelTrials& trials,
                       const CameraShares& shares) {
    return mean_of(block_variances(kWindow, pair, trials, shares, Objective::relative));
}

// 4096 pixels: standard errors of some 2% of either variance.
TEST(TrialVariance, parts_camera_paths_from_photons) {
    for (const double camera : {0.0, 0.02, 0.2})
        for (const double photon : {0.0, 0.02, 0.2}) {
            const TrialPair pair = pair_of(2, {0, camera, 0, photon});
            const auto blocks =
                block_variances(kWindow, pair, by_chance(), {}, Objective::relative);
            ASSERT_EQ(blocks.size(), 16U);
            const BlockVariance mean = mean_of(blocks);
            EXPECT_NEAR(mean.camera, camera / 4, 0.06 * (camera + photon) / 4 + 1e-12);
            EXPECT_NEAR(mean.photon / 1000, photon / 4, 0.06 * photon / 4 + 1e-12);
        }
}

// What both views share does not hide what differs between them.
TEST(TrialVariance, photons_alike_in_both_views_stay_for_any_number_of_camera_paths) {
    const TrialPair pair = pair_of(2, {0, 0.01, 0.3, 0.1});
    const BlockVariance one = measured(pair, by_chance(), {});
    EXPECT_NEAR(one.camera, 0.01 / 4, 1e-3);
    EXPECT_NEAR(one.photon / 1000, 0.4 / 4, 0.005);
    const BlockVariance four = measured(pair, by_chance(), four_each());
    EXPECT_NEAR(four.camera, 0.01 / 16, 1e-3 / 4);
    EXPECT_NEAR(four.photon / 1000, (0.3 + 0.1 / 4) / 4, 0.005);
}

// Of light that needs no photon the pixels' trials know more than two views.
TEST(TrialVariance, takes_unlit_noise_from_the_pixels_trials) {
    const TrialPair pair = pair_of(2, {0.2, 0.1, 0, 0});
    PixelTrials trials = by_chance();
    EXPECT_NEAR(measured(pair, trials, {}).camera, 0.3 / 4, 0.004) << "without trials";
    trials.rays.assign(kPixels, 1);
    trials.variance.fill(PixelValues(kPixels, 7));
    EXPECT_NEAR(measured(pair, trials, {}).camera, 7.1 / 4, 0.02);
    EXPECT_NEAR(measured(pair, trials, four_each()).camera, 7.1 / 16, 0.005);
}

TEST(TrialVariance, counts_the_gain_of_a_round) {
    const TrialPair pair = pair_of(2, {0, 0.2, 0, 0});
    PixelTrials trials = by_chance();
    const double chance = measured(pair, trials, {}).camera;
    trials.nets.assign(trials.nets.size(), {0.4});
    EXPECT_NEAR(measured(pair, trials, {}).camera / chance, std::pow(0.8, 6), 1e-9);
    EXPECT_NEAR(measured(pair, trials, four_each()).camera / chance, std::pow(0.8, 6) * 0.16, 1e-9);
}

TEST(TrialVariance, is_relative) {
    TrialPair pair = pair_of(2, {0, 0.2, 0, 0.1});
    const BlockVariance before = measured(pair, by_chance(), {});
    const auto dim = [&](const auto& pixels) {
        for (Trial* view : {&pair.one, &pair.other})
            for (PixelValues* values : {&view->camera, &view->lit.front(), &view->lit.back()})
                pixels([&](std::size_t i) { values->at(i) *= 1e-3; });
    };
    dim([](const auto& visit) {
        for (std::size_t i = 0; i < kPixels; ++i) visit(i);
    });
    const BlockVariance after = measured(pair, by_chance(), {});
    EXPECT_NEAR(after.camera, before.camera, 1e-9);
    EXPECT_NEAR(after.photon, before.photon, 1e-6);
    dim([](const auto& visit) { BlockGrid(kSize, kSize, kTrialBlock).for_pixels(3, visit); });
    const auto blocks = block_variances(kWindow, pair, by_chance(), {}, Objective::relative);
    EXPECT_LT(blocks.at(3).camera, 1e-3 * before.camera) << "errors in the dark are small";
    EXPECT_GT(blocks.at(4).camera, 0.5 * before.camera);
    pair = pair_of(2, {});
    for (Trial* view : {&pair.one, &pair.other}) view->lit.fill(PixelValues(kPixels, 0));
    EXPECT_TRUE(block_variances(kWindow, pair, by_chance(), {}, Objective::relative).empty());
}

TEST(TrialVariance, is_that_of_the_pixels_that_both_views_have) {
    TrialPair pair = pair_of(2, {0, 0.2, 0, 0.1});
    const BlockVariance whole = measured(pair, by_chance(), {});
    pair.cells = 2;
    const PixelCells cells{kWindow, 2};
    for (std::size_t i = 0; i < kPixels; ++i)
        if (!cells.has(i)) pair.other.lit[0][i] = pair.other.lit[1][i] = 0;
    const BlockVariance part = measured(pair, by_chance(), {});
    EXPECT_NEAR(part.camera / whole.camera, 1, 0.1);
    EXPECT_NEAR(part.photon / whole.photon, 1, 0.1);
}

}  // namespace
}  // namespace sunfleck::engine
