// The choice who brings indirect light: what trials measure, and how errors are compared.
#include "planning/indirect_choice.h"

#include "planning/judged_blocks.h"
#include "planning/way_tuning.h"
#include "render/pass.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

double relative_error(const WayTrials& one, const WayTrials& other) {
    return error_of_way(one, other, Objective::relative);
}

/// Trials of one pass, with the noise of camera paths alone.
WayTrials trials(double variance, double light = 1, double work = 1) {
    const std::vector<double> nothing(4, 0.0);
    return {
        {std::vector(4, light), std::vector(4, variance), work, 1}, {nothing, nothing, 0, 1}, 2};
}

TEST(ErrorOfWay, is_variance_over_squared_brightness_times_work) {
    const WayTrials usual = trials(0.1);
    const double error = relative_error(usual, usual);
    EXPECT_NEAR(error, 0.1 / 1.01, 1e-12);
    EXPECT_NEAR(relative_error(trials(0.2), usual), 2 * error, 1e-12);
    EXPECT_NEAR(relative_error(trials(0.1, 1, 3), usual), 3 * error, 1e-12);
    EXPECT_NEAR(relative_error(trials(0.1, 2), trials(0.1, 2)), error / 4, 1e-12);
}

/// Two ways with the same noise, one in the dark and one in the light, beside each other.
TEST(ErrorOfWay, knows_no_dark_where_errors_are_absolute) {
    const auto noise_in = [](std::size_t block) {
        WayTrials uneven = trials(0);
        uneven.camera.light = {0.1, 1.9, 1, 1};
        uneven.camera.variance.at(block) = 0.1;
        return uneven;
    };
    const auto error_in = [&](std::size_t block, Objective objective) {
        return error_of_way(noise_in(block), noise_in(block), objective);
    };
    EXPECT_NEAR(error_in(0, Objective::absolute), 0.1 / 4, 1e-12);
    EXPECT_NEAR(error_in(1, Objective::absolute), 0.1 / 4, 1e-12);
    EXPECT_NEAR(error_in(0, Objective::relative) / error_in(1, Objective::relative),
                (1.9 * 1.9 + 0.01) / (0.1 * 0.1 + 0.01), 1e-9);
}

TEST(ErrorOfWay, splits_work_between_camera_and_photon_paths) {
    // n camera passes and m photon passes have the variance .1/n + .4/m, for the work n + 9 m:
    // least for a unit of work at n = 1/7, m = 2/21.
    WayTrials both = trials(0.1);
    both.photons.variance = std::vector(4, 0.4);
    both.photons.work = 9;
    EXPECT_NEAR(relative_error(both, both), (0.1 * 7 + 0.4 * 21 / 2) / 1.01, 1e-9);
    both.sets = 0;  // no photons tried
    EXPECT_NEAR(relative_error(both, both), 0.1 / 1.01, 1e-9);
}

TEST(ErrorOfWay, is_large_where_the_other_way_found_light_that_this_one_missed) {
    EXPECT_GT(relative_error(trials(0, 0), trials(0.01)), 0.9);
    EXPECT_LT(relative_error(trials(0.1), trials(0, 0)), 0.11);
    // Blocks that are darker by chance are balanced by brighter ones.
    WayTrials uneven = trials(0.1);
    uneven.camera.light = {0.9, 1.1, 1, 1};
    EXPECT_NEAR(relative_error(uneven, trials(0.1)), 0.1 / 1.01, 0.01);
}

// Dark blocks are few, and their light is little of all.
TEST(ErrorOfWay, is_large_where_light_is_missing_in_one_dark_block) {
    WayTrials without = trials(0);
    without.camera.light = {0, 1.2, 1, 1};
    WayTrials with = trials(0);
    with.camera.light = {0.2, 1, 1, 1};
    EXPECT_GT(relative_error(without, with), 0.15);
    EXPECT_EQ(relative_error(with, without), 0);
    // One flash of the other way is no light that this one lacks.
    with.camera.variance[0] = 0.04;
    EXPECT_EQ(relative_error(without, with), 0);
}

/// What four trials of camera paths that go on have not found is rarer than one in four.
TEST(ErrorOfWay, counts_what_camera_paths_have_missed_by_their_trials) {
    WayTrials one = trials(0, 0);
    one.camera.passes = 4;
    const double missed_by_photons = relative_error(one, trials(0.01));
    one.goes_beyond = true;
    EXPECT_NEAR(relative_error(one, trials(0.01)), 4 * missed_by_photons, 1e-9);
    one.sets = 0;  // photons may bring it
    EXPECT_EQ(relative_error(one, trials(0.01)), 0);
}

TEST(ErrorOfWay, is_zero_in_the_dark) {
    EXPECT_EQ(relative_error(trials(0, 0), trials(0, 0)), 0);
}

/// A floor and a wall in the light of a lamp, and a ball of glass.
Scene corner() {
    return scene_of(view("0 -2.5 1.2  0 0 0.5  0 0 1", 40, 32) +
                    "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 5]\n" +
                    quad("-.5 -.5 3  -.5 .5 3  .5 .5 3  .5 -.5 3") + "AttributeEnd\n" +
                    diffuse("0.5 0.5 0.5") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                    quad("-2 1 0  2 1 0  2 1 2  -2 1 2") +
                    "AttributeBegin\nTranslate 0 0 .31\nMaterial \"dielectric\"\n"
                    "Shape \"sphere\" \"float radius\" .3\nAttributeEnd\n");
}

/// Returns the mean of a pixel.
double light_of(const WayTrials& trials) {
    return mean_value(trials.camera.light) + mean_value(trials.photons.light);
}

/// What passes measure.
struct OfPasses {
    double light = 0;     // mean of a pixel
    double variance = 0;  // of a block's mean in one pass, as the mean over blocks
};

class TrialsOfWay : public ::testing::TestWithParam<IndirectLight> {
protected:
    TrialsOfWay() {
        settings_.transport.indirect = GetParam();
        settings_.photon.adaptive_pixels = false;
        settings_.alpha = 0.999;  // discs that hardly shrink have one bias
        epoch_ = learn_epoch(scene_, settings_, 0);
    }

    /// @param cells  side of those with one camera path each, whose discs are wider by that.
    WayTrials trials(int cells = 1) const {
        const PassScene at_wavelengths(scene_, {1, 0});
        const PilotName name{1, 0};
        CameraPass camera{at_wavelengths, epoch_.transport, settings_.camera,
                          window_of(scene_.film()), name.iteration(0)};
        camera.cells = cells;
        camera.radius_factor = cells;
        const CameraTrial seen = view_of(camera);
        WayTrials trials = camera_trials(camera, seen, name);
        for (int more = 0; more < 2; ++more)
            add_photon_trials(camera, seen, epoch_.strata, name, trials);
        return trials;
    }

    OfPasses passes(std::uint32_t count) const {
        const BlockGrid blocks = judged_blocks(window_of(scene_.film()));
        std::vector<double> sums(blocks.count());
        std::vector<double> squares(blocks.count());
        for (std::uint32_t pass = 0; pass < count; ++pass) {
            const PassResult result = render_pass(scene_, settings_, pass, epoch_);
            const auto light = block_sums(blocks, luminance_of(result.image));
            for (std::size_t b = 0; b < blocks.count(); ++b) {
                const double mean = light[b] / static_cast<double>(blocks.block(b).pixels());
                sums[b] += mean;
                squares[b] += mean * mean;
            }
        }
        const double light = mean_value(sums) / count;
        for (std::size_t b = 0; b < blocks.count(); ++b)
            squares[b] = (squares[b] - sums[b] * sums[b] / count) / (count - 1);
        return {light, mean_value(squares)};
    }

    const Scene scene_ = corner();
    RenderSettings settings_;
    Epoch epoch_;
};

TEST_P(TrialsOfWay, tell_light_and_noise_of_passes) {
    const WayTrials measured = trials();
    const OfPasses truth = passes(12);
    EXPECT_NEAR(light_of(measured), truth.light, 0.03 * truth.light);
    const double variance =
        mean_value(measured.camera.variance) + mean_value(measured.photons.variance);
    // Trials do not have the noise of where visible points are, all sets share them.
    EXPECT_GT(variance, 0.2 * truth.variance);
    EXPECT_LT(variance, 2 * truth.variance);
    EXPECT_EQ(measured.sets, 2 * kWaySets);
    EXPECT_NEAR(measured.photons.passes, 1, 0.01);
}

/// A fourth of the camera paths has four times the noise, at a fourth of the work.
TEST_P(TrialsOfWay, tell_it_by_few_camera_paths) {
    const WayTrials all = trials();
    const WayTrials few = trials(2);
    EXPECT_EQ(few.blocks(), 4U);
    EXPECT_NEAR(light_of(few), light_of(all), 0.05 * light_of(all));
    EXPECT_NEAR(few.camera.work / all.camera.work, 1, 0.1);
    // Of blocks with four times as many pixels.
    const double noise = 4 * mean_value(few.camera.variance) / mean_value(all.camera.variance);
    EXPECT_GT(noise, 0.5);
    EXPECT_LT(noise, 2);
    EXPECT_NEAR(few.photons.work / all.photons.work, 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(BothWays, TrialsOfWay,
                         ::testing::Values(IndirectLight::photons, IndirectLight::sampled),
                         [](const auto& info) { return std::string(name_of(info.param)); });

}  // namespace
}  // namespace sunfleck::engine
