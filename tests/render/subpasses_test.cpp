// A pass of several subpasses: their mean, with numbers of their own for photon paths and one net
// of numbers for all their camera paths.
#include "support/picture_spread.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr std::uint32_t kSubpasses = 4;
constexpr std::uint32_t kPasses = 128;

PictureSpread spread_of_subpasses(const Scene& scene, const RenderSettings& settings, Aov aov,
                                  std::uint32_t subpasses) {
    Epoch epoch = learn_epoch(scene, settings, 0);
    epoch.subpasses = subpasses;
    return spread_of(scene, settings, epoch, {0, kPasses}, aov);
}

class Draws : public ::testing::Test {
protected:
    Draws() {
        settings_.photon.paths_per_pass = 500;
        settings_.transport.indirect = IndirectLight::photons;
        settings_.aovs[static_cast<std::size_t>(Aov::direct)] = true;
        settings_.aovs[static_cast<std::size_t>(Aov::indirect)] = true;
    }

    /// Variances are means over 144 pixels and 128 passes, known to some percent.
    void expect_mean_of_subpasses(Aov aov, double least, double most) {
        expect_mean_of_subpasses(procedural("cornell", 12), aov, least, most);
    }
    void expect_mean_of_subpasses(const Scene& scene, Aov aov, double least, double most) {
        const PictureSpread one = spread_of_subpasses(scene, settings_, aov, 1);
        const PictureSpread four = spread_of_subpasses(scene, settings_, aov, kSubpasses);
        EXPECT_NEAR(four.mean / one.mean, 1, 0.02);
        EXPECT_GT(four.variance / one.variance, least);
        EXPECT_LT(four.variance / one.variance, most);
    }

    RenderSettings settings_;
};

// Subpasses that shared their camera paths' numbers would leave the variance as it is; drawn apart
// they would leave a quarter. They are a net together.
TEST_F(Draws, take_the_camera_paths_noise_away) {
    expect_mean_of_subpasses(Aov::direct, 0.05, 0.2);
}

TEST_F(Draws, take_the_photons_noise_away) {
    expect_mean_of_subpasses(Aov::indirect, 0.2, 0.3);
}

// Chains that shared their numbers would leave the variance as it is.
TEST_F(Draws, take_the_chains_noise_away) {
    const Scene scene = procedural("cognac-1", 12);
    settings_.photon.paths_per_pass = 2000;
    settings_.aovs[static_cast<std::size_t>(Aov::caustic)] = true;
    ASSERT_FALSE(learn_epoch(scene, settings_, 0).strata[0].plan.levels.empty());
    expect_mean_of_subpasses(scene, Aov::caustic, 0.15, 0.4);
}

// Each photon that a visible point accepts is a deposit.
TEST_F(Draws, tell_how_many_photons_a_pixel_took) {
    const Scene scene = procedural("cornell", 12);
    settings_.aovs[static_cast<std::size_t>(Aov::samples)] = true;
    Epoch epoch = learn_epoch(scene, settings_, 0);
    for (const std::uint32_t subpasses : {1U, kSubpasses}) {
        epoch.subpasses = subpasses;
        const PassResult pass = render_pass(scene, settings_, 0, epoch);
        double taken = 0;
        for (std::size_t i = 0; i < pass.image.pixels(); ++i)
            taken += pass.image.value(Aov::samples, i, 0).to_double();
        EXPECT_EQ(taken, static_cast<double>(pass.statistics[Count::deposits]));
        EXPECT_GT(taken, 0);
    }
}

TEST_F(Draws, count_all_their_paths) {
    const Scene scene = procedural("cornell", 12);
    Epoch epoch = learn_epoch(scene, settings_, 0);
    const PassResult one = render_pass(scene, settings_, 0, epoch);
    epoch.subpasses = kSubpasses;
    const PassResult four = render_pass(scene, settings_, 0, epoch);
    EXPECT_EQ(four.subpasses, kSubpasses);
    EXPECT_EQ(four.statistics[Count::uniform_paths],
              kSubpasses * one.statistics[Count::uniform_paths]);
    EXPECT_NEAR(static_cast<double>(four.statistics[Count::camera_rays]),
                kSubpasses * static_cast<double>(one.statistics[Count::camera_rays]),
                0.1 * static_cast<double>(four.statistics[Count::camera_rays]));
    ASSERT_EQ(four.strata.size(), one.strata.size());
    EXPECT_EQ(four.strata[0].paths, kSubpasses * one.strata[0].paths);
    EXPECT_NEAR(four.visible_fraction / one.visible_fraction, 1, 0.2);
    EXPECT_NEAR(four.strata[0].visible_fraction / one.strata[0].visible_fraction, 1, 0.2);
}

}  // namespace
}  // namespace sunfleck::engine
