// The first passes of a large picture: a quarter of the photons, and the same mean.
#include "film/pass_weight.h"
#include "math/statistics.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

RenderSettings settings_of(std::size_t large_picture, std::uint64_t seed = 0) {
    RenderSettings settings;
    settings.photon.paths_per_pass = 8'000;
    settings.large_picture = large_picture;
    settings.seed = seed;
    return settings;
}

TEST(SmallPasses, are_the_first_of_large_pictures) {
    RenderSettings settings = settings_of(400);
    EXPECT_EQ(small_passes(settings, 399), 0U);
    EXPECT_EQ(small_passes(settings, 400), kSmallPasses);
    settings.photon.sampler = PhotonSampler::paper;  // each pass depends on those before
    EXPECT_EQ(small_passes(settings, 400), 0U);
    settings = settings_of(400);
    settings.integrator = Integrator::path;  // has no photons
    EXPECT_EQ(small_passes(settings, 400), 0U);
}

double photon_paths(const PassResult& pass) {
    std::uint64_t paths = 0;
    for (const StratumCounts& stratum : pass.strata) paths += stratum.paths;
    return static_cast<double>(paths);
}

TEST(SmallPasses, have_a_quarter_of_the_photon_paths_and_a_camera_path_a_pixel) {
    const Scene scene = procedural("cognac-1", 20);
    const RenderSettings settings = settings_of(1);
    Epoch epoch = learn_epoch(scene, settings, 0);
    epoch.log2_samples.assign(400, 1);  // two camera paths a pixel
    const PassResult small = render_pass(scene, settings, kSmallPasses - 1, epoch);
    const PassResult next = render_pass(scene, settings, kSmallPasses, epoch);
    EXPECT_EQ(small.statistics[Count::camera_paths], 400U);
    EXPECT_EQ(next.statistics[Count::camera_paths], 800U);
    EXPECT_NEAR(photon_paths(small), photon_paths(next) / 4, 8);
}

/// Brightness of pass 0, small or not, over 200 seeds: the 99% interval of its ratio lies within
/// 2% of one.
TEST(SmallPasses, have_the_expectation_of_others) {
    const Scene scene = procedural("cognac-1", 16);
    const Epoch epoch = learn_epoch(scene, settings_of(1), 0);
    RunningMean small;
    RunningMean whole;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto brightness = [&](std::size_t large_picture) {
            const PassResult pass = render_pass(scene, settings_of(large_picture, seed), 0, epoch);
            double sum = 0;
            for (std::size_t i = 0; i < 256; ++i) sum += luminance(pixel_value(pass.image, i));
            return sum / 256;
        };
        small.add(brightness(1));
        whole.add(brightness(1'000'000));
    }
    const double ratio = small.mean() / whole.mean();
    const double error =
        std::hypot(small.standard_error() / small.mean(), whole.standard_error() / whole.mean());
    EXPECT_LT(std::abs(ratio - 1) + 2.58 * error, 0.02) << ratio << " +- " << error;
}

}  // namespace
}  // namespace sunfleck::engine
