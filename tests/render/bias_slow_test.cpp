// Bias of the discs' radius on pictures whose light is known: what films say of it, and what is
// left when it is subtracted.
//
// Light from a lamp falls to a floor by photons alone, gathered from discs of eight pixels' radius
// at first. Without discs the floor is known in closed form.
#include "film/bias.h"
#include "film/film_picture.h"
#include "math/statistics.h"
#include "render/progressive.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSize = 32;  // pixels, over a floor of 2 x 2
constexpr std::uint32_t kPasses = 256;
constexpr std::size_t kBlocks = 16;

std::string floor_text(const std::string& light) {
    const double fov = 2 * std::atan(0.25) * 180 / kPiDouble;
    return view("0 0 4  0 0 0  0 1 0", fov, kSize) + light + diffuse("0.5 0.5 0.5") +
           quad("-9 -9 0  9 -9 0  9 9 0  -9 9 0");
}

RenderResult film_of(const Scene& scene, std::uint64_t seed, std::uint32_t paths) {
    RenderSettings settings;
    settings.transport.direct = DirectLight::photons;
    settings.transport.max_depth = 1;
    settings.photon.sampler = PhotonSampler::random;
    settings.photon.paths_per_pass = paths;
    settings.eye.radius_pixels = 8;
    settings.seed = seed;
    RenderJob job{scene, settings, {}, 0};
    job.stop.end_pass = kPasses;
    return render(job, {});
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
    std::array<RunningMean, kBlocks> bias;   // the true one: mean less truth
    std::array<RunningMean, kBlocks> claim;  // as estimated
    RunningMean plain;                       // mean squared error of blocks
    RunningMean extrapolated;
    int covered = 0;  // claims whose interval of 95% holds the true bias
    int claims = 0;

    /// Part of the bias, over all blocks, that is estimated: the slope of claims over the truth.
    double share() const {
        double product = 0;
        double square = 0;
        for (std::size_t b = 0; b < kBlocks; ++b) {
            product += bias.at(b).mean() * claim.at(b).mean();
            square += bias.at(b).mean() * bias.at(b).mean();
        }
        return product / square;
    }
};

template <class Radiance>
Seen look(const Scene& scene, int seeds, std::uint32_t paths, const Radiance& radiance) {
    const auto truth = blocks_of([&](std::size_t i) { return pixel_truth(i, radiance); });
    std::vector<Film> films;
    Seen seen;
    for (int seed = 0; seed < seeds; ++seed) {
        films.push_back(film_of(scene, static_cast<std::uint64_t>(seed), paths).film);
        const Picture plain = film_picture(films.back());
        const Picture without = film_picture(films.back(), {1, true});
        const auto means = blocks_of([&](std::size_t i) { return at(plain, i); });
        const auto extrapolated = blocks_of([&](std::size_t i) { return at(without, i); });
        double of_plain = 0;
        double of_extrapolated = 0;
        const auto claims = block_biases(films.back());
        for (std::size_t b = 0; b < kBlocks; ++b) {
            seen.bias.at(b).add(means.at(b) - truth.at(b));
            seen.claim.at(b).add(claims[b].value);
            of_plain += std::pow(means.at(b) - truth.at(b), 2) / kBlocks;
            of_extrapolated += std::pow(extrapolated.at(b) - truth.at(b), 2) / kBlocks;
        }
        seen.plain.add(of_plain);
        seen.extrapolated.add(of_extrapolated);
    }
    constexpr double kQuantile = 2.145;  // of t with 14 degrees of freedom: 16 rounds
    for (const Film& film : films) {
        const auto claims = block_biases(film);
        for (std::size_t b = 0; b < kBlocks; ++b, ++seen.claims) {
            const double off = claims[b].value - seen.bias.at(b).mean();
            seen.covered += std::abs(off) < kQuantile * claims[b].standard_error ? 1 : 0;
        }
    }
    return seen;
}

/// A lamp a little above the floor: light is smooth, so its bias is linear in the discs' area.
TEST(Bias, of_smooth_light_is_seen_and_taken_away) {
    constexpr double kHeight = 0.7;
    const Scene scene =
        scene_of(floor_text("LightSource \"point\" \"point3 from\" [0 0 0.7] \"rgb I\" [8 8 8]\n"));
    const Seen seen = look(scene, 40, 4000, [&](double x, double y) {
        return 0.5 / kPiDouble * 8 * kHeight / std::pow(x * x + y * y + kHeight * kHeight, 1.5);
    });
    std::printf("share %.4f plain %.3g extr %.3g covered %d of %d\n", seen.share(),
                seen.plain.mean(), seen.extrapolated.mean(), seen.covered, seen.claims);
    for (std::size_t b = 0; b < kBlocks; ++b)
        std::printf("%zu bias %.4f +- %.4f claim %.4f +- %.4f\n", b, seen.bias[b].mean(),
                    seen.bias[b].standard_error(), seen.claim[b].mean(),
                    seen.claim[b].standard_error());
}

/// The edge of a shadow, across blocks: the bias there falls with the radius, not the area.
TEST(Bias, at_an_edge_is_partly_seen_and_taken_away) {
    const Scene scene = scene_of(
        floor_text("LightSource \"distant\" \"point3 from\" [1 0 1] \"point3 to\" [0 0 0]\n") +
        quad("2 -9 0  2 9 0  2 9 1.9  2 -9 1.9"));
    const Seen seen = look(scene, 10, 20000, [](double x, double) {
        return x > -0.1 ? 0.5 / kPiDouble * std::sqrt(0.5) : 0;
    });
    std::printf("share %.4f plain %.3g extr %.3g covered %d of %d\n", seen.share(),
                seen.plain.mean(), seen.extrapolated.mean(), seen.covered, seen.claims);
    for (std::size_t b = 0; b < kBlocks; ++b)
        std::printf("%zu bias %.4f +- %.4f claim %.4f +- %.4f\n", b, seen.bias[b].mean(),
                    seen.bias[b].standard_error(), seen.claim[b].mean(),
                    seen.claim[b].standard_error());
}

}  // namespace
}  // namespace sunfleck
