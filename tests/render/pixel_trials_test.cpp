// Trial paths of pixels: their noise, and how it falls with nets.
#include "render/pixel_trials.h"

#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSide = 48;

/// A lamp before nothing, that fills the lower half: its rim runs through pixels.
Scene half_lit() {
    return scene_of(view("0 0 4  0 0 0  0 1 0", 40, kSide) +
                    "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                    quad("-9 -9 0  9 -9 0  9 .01 0  -9 .01 0") + "AttributeEnd\n");
}

PixelTrials trials_in(const Scene& scene, const TrialViews& views) {
    const RenderSettings settings;
    const PassScene at_wavelengths(scene, {7, 0});
    const EyePass pass{at_wavelengths, settings.transport, settings.eye,
                       PixelWindow{0, 0, kSide, kSide}, PassId{7, 0}};
    return trials_of_pixels(pass, {7, 0}, views);
}

TEST(NetLaw, is_that_of_chance_at_one_half) {
    const NetLaw chance{0.5};
    EXPECT_EQ(chance.left(0), 1);
    EXPECT_EQ(chance.left(6), 1.0 / 64);
    EXPECT_EQ(chance.of_round(), 1);
}

// Light with an edge: a variance of n^-1.5, so that sixteen paths have a quarter of chance's.
TEST(NetLaw, of_edges_spares_three_quarters_in_a_round) {
    const NetLaw edges{0.35355339};
    EXPECT_NEAR(edges.left(2), 0.125, 1e-6);
    EXPECT_NEAR(edges.of_round(), 0.125, 1e-6) << "the first points of a net gain most";
}

// p (1 - p) of the pixels that the rim parts, up to 1/4 of light 1: by the Gaussian filter about
// three rows of them.
TEST(PixelTrials, find_the_noise_of_a_rim_and_none_beside_it) {
    for (const int cells : {1, 2, 3}) {
        const PixelTrials trials = trials_in(half_lit(), {4, cells});
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
            EXPECT_NEAR(rim / kSide, 0.55, 0.2) << cells;
        }
        EXPECT_EQ(trials.rays.front(), 1) << "into nothing";
    }
}

// An edge parts a net of four by a variance of about 1/8 that of one path; flashes gain nothing.
TEST(PixelTrials, know_how_far_nets_help) {
    const PixelTrials trials = trials_in(half_lit(), {8, 1});
    const std::size_t block = 4;  // the middle of 3 x 3
    EXPECT_LT(trials.nets.at(block).doubling, 0.42);
    EXPECT_GE(trials.nets.at(block).doubling, 0.25);
    EXPECT_EQ(trials.nets.at(0).doubling, NetLaw{}.doubling) << "no noise: as usual";
}

TEST(PixelTrials, are_none_where_none_are_made) {
    const PixelTrials none = no_trials({0, 0, 40, 20});
    EXPECT_FALSE(none.are_made());
    EXPECT_FALSE(none.have_noise());
    EXPECT_EQ(none.nets.size(), 6U);
}

}  // namespace
}  // namespace sunfleck
