// Two lamps in strata of their own bring what uniform paths from both bring.
#include "support/two_lamps.h"

#include <gtest/gtest.h>

#include <array>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

// 99% of a ratio of means lies within 5% of one: 60 renders of 4 passes, seeds 0 .. 59, for the
// light that photons bring to the whole picture and to its left half. Each lamp brings a fifth of
// it or more, so one that is left out or weighed wrong by a third is seen.
TEST(LightStrataNightly, bring_the_light_of_uniform_paths) {
    constexpr int kPixels = 12;
    constexpr int kRenders = 60;
    const Scene scene = two_lamps(kPixels, 60);
    const auto means = [&](PhotonSampler sampler, std::uint32_t paths) {
        std::array<std::vector<double>, 2> means;
        for (int i = 0; i < kRenders; ++i) {
            RenderSettings settings;
            settings.seed = static_cast<std::uint64_t>(i);
            settings.aovs.fill(true);
            settings.photon.sampler = sampler;
            settings.transport.indirect = IndirectLight::photons;
            settings.photon.paths_per_pass = paths;
            const MeanPicture picture = render_mean(scene, settings, 4, Aov::indirect);
            means[0].push_back(luminance(picture.mean(0, 0, kPixels / 2, kPixels)));
            means[1].push_back(luminance(picture.mean()));
        }
        return means;
    };
    const auto stratified = means(PhotonSampler::adaptive, 40'000);
    const auto uniform = means(PhotonSampler::uniform, 100'000);
    for (std::size_t part = 0; part < 2; ++part) {
        const Estimate a = Estimate::of(stratified[part]);
        const Estimate b = Estimate::of(uniform[part]);
        EXPECT_LT(worst_ratio(a, b), 0.05)
            << a.mean << " +- " << a.error << ", " << b.mean << " +- " << b.error;
    }
}

}  // namespace
}  // namespace sunfleck::engine
