// Trial paths of pixels: their noise, and how it falls with nets.
#include "planning/pixel_trials.h"

#include "camera_paths/trace_camera_paths.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSide = 48;

/// A lamp before nothing, that fills the lower half: its rim runs through pixels.
Scene half_lit() {
    return scene_of(view("0 0 4  0 0 0  0 1 0", 40, kSide) +
                    "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                    quad("-9 -9 0  9 -9 0  9 .01 0  -9 .01 0") + "AttributeEnd\n");
}

/// At the wavelengths of one pass, with what asks for it.
template <class Ask>
auto in_a_pass(const Scene& scene, const Ask& ask) {
    const RenderSettings settings;
    const PassScene at_wavelengths(scene, {7, 0});
    return ask(CameraPass{at_wavelengths, settings.transport, settings.camera,
                          PixelWindow{0, 0, kSide, kSide}, PassId{7, 0}});
}

PixelTrials trials_in(const Scene& scene, const TrialEffort& views) {
    return in_a_pass(scene, [&](const CameraPass& pass) {
        return trials_of_pixels(pass, {7, 0}, views);
    });
}

/// Of the lamp itself, at these wavelengths.
double brightness_below(const Scene& scene) {
    return in_a_pass(scene, [](const CameraPass& pass) {
        PassImage image(pass.window.pixels(), {});
        Statistics unused;
        trace_camera_paths(pass, image, unused);
        return luminance_of(image).back();
    });
}

TEST(VarianceDecay, is_that_of_chance_at_one_half) {
    const VarianceDecay chance{0.5};
    EXPECT_EQ(chance.left(0), 1);
    EXPECT_EQ(chance.left(6), 1.0 / 64);
    EXPECT_EQ(chance.of_batch(), 1);
}

// Light with an edge: a variance of n^-1.5, so that four paths leave half of what chance does. The
// law of sixteen is the 1.5th power of that.
TEST(VarianceDecay, of_edges_leaves_a_third_in_a_round) {
    const VarianceDecay edges{std::pow(0.5, 0.25) / 2};
    EXPECT_NEAR(edges.left(1), 0.42, 0.001);
    EXPECT_NEAR(edges.left(2), 0.177, 0.001);
    EXPECT_NEAR(edges.of_batch(), std::pow(0.5, 1.5), 1e-12);
}

// The rim covers .165 of one row of pixels: by the box filter a variance of .138 of the lamp's
// brightness squared. Halves of 4 x 48 paths of that row, or fewer: standard errors of .014 at
// most.
TEST(PixelTrials, find_the_noise_of_a_rim_and_none_beside_it) {
    const double lamp = brightness_below(half_lit());
    for (const auto& [pairs, cells] : {std::pair{1U, 1}, {6U, 1}, {6U, 2}, {8U, 3}}) {
        const PixelTrials trials = trials_in(half_lit(), {pairs, cells});
        ASSERT_TRUE(trials.have_noise());
        for (const PixelValues& half : trials.variance) {
            double rim = 0;
            for (std::size_t i = 0; i < half.size(); ++i) {
                const std::size_t y = i / kSide;
                if (y < 15 || y > 32) {
                    EXPECT_EQ(half[i], 0) << i;
                }
                rim += half[i];
            }
            EXPECT_NEAR(rim / (kSide * lamp * lamp), 0.138, 0.05) << pairs << " " << cells;
        }
        EXPECT_EQ(trials.rays.front(), 1) << "into nothing";
    }
}

// The rim runs along a row, through one of the four strata of a net: at .66 of it, a variance of
// .66 x .34 / 16 for the mean of four, where chance has .138 / 4. The fourth root of that is .80;
// its half is measured to .011 (one standard error).
TEST(PixelTrials, know_how_far_nets_help) {
    const PixelTrials trials = trials_in(half_lit(), {8, 1});
    const std::size_t block = 4;  // the middle of 3 x 3
    EXPECT_NEAR(trials.nets.at(block).doubling, 0.80 / 2, 0.035);
    EXPECT_NE(trials.nets.at(block).doubling, VarianceDecay{}.doubling) << "measured";
    EXPECT_EQ(trials.nets.at(0).doubling, VarianceDecay{}.doubling) << "no noise: as usual";
}

TEST(PixelTrials, are_none_where_none_are_made) {
    const PixelTrials none = no_trials({0, 0, 40, 20});
    EXPECT_FALSE(none.are_made());
    EXPECT_FALSE(none.have_noise());
    EXPECT_EQ(none.nets.size(), 6U);
}

}  // namespace
}  // namespace sunfleck::engine
