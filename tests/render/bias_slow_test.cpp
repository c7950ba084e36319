// Bias of the discs' radius on pictures whose light is known: what films say of it, and what is
// left when it is subtracted.
//
// A floor gets light from photons alone, gathered from discs of several pixels' radius. Without
// discs it is known in closed form.
#include "film/bias.h"
#include "film/film_picture.h"
#include "math/statistics.h"
#include "render/progressive.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSize = 32;  // pixels, over a floor of 2 x 2
constexpr std::uint32_t kPasses = 128;
constexpr double kQuantile = 2.447;  // of t with six degrees of freedom, for eight batches: 95%
constexpr std::size_t kBlocks = 16;

/// A camera above a floor. @param up  the direction of the picture's upper edge.
std::string floor_text(const std::string& up, const std::string& light, const std::string& size) {
    const double fov = 2 * std::atan(0.25) * 180 / kPiDouble;
    const std::string m = "-" + size;
    return view("0 0 4  0 0 0  " + up, fov, kSize) + light + diffuse("0.5 0.5 0.5") +
           quad(m + " " + m + " 0  " + size + " " + m + " 0  " + size + " " + size + " 0  " + m +
                " " + size + " 0");
}

RenderSettings settings_for(double radius_pixels, std::uint32_t paths) {
    RenderSettings settings;
    settings.transport.direct = DirectLight::photons;
    settings.transport.max_depth = 1;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = paths;
    settings.camera.radius_pixels = radius_pixels;
    return settings;
}

Film film_of(const Scene& scene, const RenderSettings& settings) {
    RenderJob job{scene, settings, {}, 0};
    job.stop.end_pass = kPasses;
    return render(job, {}).film;
}

/// Means of something over each block. @param value  of a pixel.
template <class Value>
std::array<double, kBlocks> blocks_of(const Value& value) {
    std::array<double, kBlocks> means{};
    for (std::size_t i = 0; i < kSize * kSize; ++i)
        means.at(i / kSize / 8 * 4 + i % kSize / 8) += value(i) / 64;
    return means;
}

/// Mean over a pixel of what the floor sends up. @param radiance  at x, y of the floor.
template <class Radiance>
double pixel_truth(std::size_t pixel, const Radiance& radiance) {
    constexpr int kSteps = 16;
    double sum = 0;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const double x = static_cast<double>(pixel % kSize) + (i % kSteps + 0.5) / kSteps;
        const double y = static_cast<double>(pixel / kSize) + (i / kSteps + 0.5) / kSteps;
        sum += radiance(2 * x / kSize - 1, 1 - 2 * y / kSize) / (kSteps * kSteps);
    }
    return sum;
}

double at(const Picture& picture, std::size_t pixel) {
    return luminance(Vec3d(picture.find("R")->values[pixel], picture.find("G")->values[pixel],
                           picture.find("B")->values[pixel]));
}

/// What many films say of their blocks.
struct Seen {
    std::array<RunningMean, kBlocks> bias;  // the true one: mean less truth
    RunningMean share;                      // of that bias, over all blocks, as estimated
    RunningMean plain;                      // mean squared error of blocks
    RunningMean extrapolated;
    double covered = 0;  // share of estimates whose interval of 95% holds the true bias
};

/// Over seeds: errors first, and then estimates against the mean of these.
template <class Radiance>
Seen look(const Scene& scene, RenderSettings settings, int seeds, const Radiance& radiance) {
    const auto truth = blocks_of([&](std::size_t i) { return pixel_truth(i, radiance); });
    std::vector<std::vector<Bias>> estimates;
    Seen seen;
    const auto squared_error = [&](const Picture& picture, bool keep) {
        const auto means = blocks_of([&](std::size_t i) { return at(picture, i); });
        double sum = 0;
        for (std::size_t b = 0; b < kBlocks; ++b) {
            const double error = means.at(b) - truth.at(b);
            if (keep) seen.bias.at(b).add(error);
            sum += error * error / kBlocks;
        }
        return sum;
    };
    for (int seed = 0; seed < seeds; ++seed) {
        settings.seed = static_cast<std::uint64_t>(seed);
        const Film film = film_of(scene, settings);
        seen.plain.add(squared_error(film_picture(film), true));
        seen.extrapolated.add(squared_error(film_picture(film, {true}), false));
        estimates.push_back(block_biases(film));
    }
    for (const std::vector<Bias>& blocks : estimates) {
        double product = 0;
        double square = 0;
        for (std::size_t b = 0; b < kBlocks; ++b) {
            const double bias = seen.bias.at(b).mean();
            product += bias * blocks[b].value;
            square += bias * bias;
            const double off = std::abs(blocks[b].value - bias);
            if (off < kQuantile * blocks[b].standard_error) seen.covered += 1.0 / kBlocks / seeds;
        }
        seen.share.add(product / square);
    }
    return seen;
}

/// A lamp a little above the floor: light is smooth, so its bias is linear in the discs' area. With
/// a radius of 8 pixels, a third of the lamp's height, the second order is some percent of it.
TEST(Bias, of_smooth_light_is_seen_and_taken_away) {
    constexpr double kHeight = 0.7;
    const Scene scene = scene_of(floor_text(
        "0 1 0", "LightSource \"point\" \"point3 from\" [0 0 0.7] \"rgb I\" [8 8 8]\n", "9"));
    const Seen seen = look(scene, settings_for(8, 3000), 30, [&](double x, double y) {
        return 0.5 / kPiDouble * 8 * kHeight / std::pow(x * x + y * y + kHeight * kHeight, 1.5);
    });
    EXPECT_NEAR(seen.share.mean(), 1, 0.08);
    EXPECT_LT(seen.share.standard_error(), 0.01);
    EXPECT_LT(10 * seen.extrapolated.mean(), seen.plain.mean());
    // Of 480 intervals, some off by that second order; one standard error is 1%.
    EXPECT_GT(seen.covered, 0.91);
    EXPECT_LT(seen.covered, 0.99);
}

/// The edge of a shadow, aslant over the blocks: the bias there does not fall as the area. Of that
/// of blocks more than half is found (docs/method/errors.md).
TEST(Bias, at_an_edge_is_partly_seen_and_taken_away) {
    const double angle = 0.3;
    const std::string up = std::to_string(std::sin(angle)) + " " + std::to_string(std::cos(angle));
    const Scene scene = scene_of(
        floor_text(up + " 0",
                   "LightSource \"distant\" \"point3 from\" [1 0 1] \"point3 to\" [0 0 0]\n",
                   "1.4") +
        quad("1.5 -1.4 0  1.5 1.4 0  1.5 1.4 1.4  1.5 -1.4 1.4"));
    const Seen seen = look(scene, settings_for(4, 20'000), 10, [&](double x, double y) {
        const bool lit = y * std::sin(angle) - x * std::cos(angle) < 0.1;
        return lit ? 0.5 / kPiDouble * std::sqrt(0.5) : 0;
    });
    EXPECT_GT(seen.share.mean(), 0.5);
    EXPECT_LT(seen.share.mean(), 1.1);
    EXPECT_LT(seen.share.standard_error(), 0.02);
    EXPECT_LT(4 * seen.extrapolated.mean(), seen.plain.mean());
}

/// Claimed over true standard error.
struct ErrorRatio {
    std::array<RunningMean, kBlocks> values;
    RunningMean variances;  // as claimed

    void add(std::size_t block, double value, double standard_error) {
        values.at(block).add(value);
        variances.add(standard_error * standard_error);
    }
    double ratio() const {
        double truth = 0;
        for (const RunningMean& value : values) truth += value.variance() / kBlocks;
        return std::sqrt(variances.mean() / truth);
    }
};

/// Noise of independent photons, radii of two pixels and of four. Over 24 seeds and
/// 16 blocks a ratio is known to 4%.
TEST(Bias, has_the_errors_that_are_claimed) {
    const Scene scene = scene_of(floor_text(
        "0 1 0", "LightSource \"point\" \"point3 from\" [0 0 0.7] \"rgb I\" [8 8 8]\n", "9"));
    for (const double radius : {2.0, 4.0}) {
        RenderSettings settings = settings_for(radius, 3000);
        settings.photon.sampler = PhotonSampler::random;
        ErrorRatio bias;
        ErrorRatio extrapolated;
        for (std::uint64_t seed = 0; seed < 24; ++seed) {
            settings.seed = seed;
            const Film film = film_of(scene, settings);
            const auto biases = block_biases(film);
            const auto means = block_errors(film);
            const auto errors = extrapolated_block_errors(film);
            for (std::size_t b = 0; b < kBlocks; ++b) {
                bias.add(b, biases[b].value, biases[b].standard_error);
                extrapolated.add(b, means[b].mean - biases[b].value, errors[b]);
            }
        }
        EXPECT_NEAR(bias.ratio(), 1, 0.15) << radius;
        EXPECT_NEAR(extrapolated.ratio(), 1, 0.15) << radius;
    }
}

}  // namespace
}  // namespace sunfleck::engine
