// Trial views, their spread pixel by pixel, and numbers of paths for it.
#include "render/noisy_pixels.h"

#include "render/trial_rounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace sunfleck {
namespace {

constexpr int kEvery = 2;            // columns and rows that have any
constexpr double kDarkOfMean = 0.1;  // of the mean brightness: what is darker counts as that
constexpr std::uint8_t kMostDoublings = 6;
/// Paths of a pixel of mean noise, were all numbers allowed.
constexpr std::array<double, 8> kLevels = {0.125, 0.25, 0.5, 1, 2, 4, 8, 16};
/// Camera paths of a draw, together: their points take a few hundred bytes each.
constexpr std::size_t kMostPaths = std::size_t{1} << 23U;

double mean_of(const TrialPixels& pixels) {
    return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

/// Numbers by pixel of a rectangle, row by row.
struct Raster {
    int width = 0;
    int height = 0;
    TrialPixels values;

    Raster(int w, int h)
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    double& at(int x, int y) { return values[index(x, y)]; }
    double at(int x, int y) const { return values[index(x, y)]; }
};

/// Binomial weights over a pixel and its eight neighbours.
Raster smoothed(const Raster& pixels) {
    Raster result(pixels.width, pixels.height);
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            double sum = 0;
            double weights = 0;
            for (int v = std::max(0, y - 1); v <= std::min(pixels.height - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(pixels.width - 1, x + 1); ++u) {
                    const double weight = (u == x ? 2 : 1) * (v == y ? 2 : 1);
                    sum += weight * pixels.at(u, v);
                    weights += weight;
                }
            result.at(x, y) = sum / weights;
        }
    return result;
}

TrialPixels smoothed(const TrialPixels& pixels, const PixelWindow& window) {
    Raster raster(window.width(), window.height());
    raster.values = pixels;
    return smoothed(raster).values;
}

/// What the pixels with trials tell of all: smoothed over those, then each for its kEvery x kEvery.
TrialPixels told_of_all(const TrialPixels& pixels, const PixelWindow& window) {
    Raster all(window.width(), window.height());
    Raster few(one_of(all.width, kEvery), one_of(all.height, kEvery));
    few.values = thinned(pixels, window, kEvery);
    few = smoothed(few);
    for (int y = 0; y < all.height; ++y)
        for (int x = 0; x < all.width; ++x) all.at(x, y) = few.at(x / kEvery, y / kEvery);
    return std::move(all.values);
}

/// @param relative  noise over the mean, times a level.
std::uint8_t doublings_for(double relative) {
    constexpr double kRootOf2 = 1.4142135623730951;
    std::uint8_t doublings = 0;
    for (double least = kRootOf2; doublings < kMostDoublings && relative >= least; least *= 2)
        ++doublings;
    return doublings;
}

/// Standard deviation over the root of the cost, of pixels of brightness 1.
TrialPixels noise_of(const TrialPixels& variance, const TrialPixels& rays,
                     const TrialPixels& brightness) {
    TrialPixels noise(variance.size());
    for (std::size_t i = 0; i < noise.size(); ++i)
        noise[i] = std::sqrt(variance[i] / rays[i]) / brightness[i];
    return noise;
}

/// @param level  paths of a pixel of mean noise.
Doublings doublings_of(const TrialPixels& noise, double level) {
    const double scale = level / mean_of(noise);
    Doublings doublings;
    doublings.reserve(noise.size());
    for (const double n : noise) doublings.push_back(doublings_for(n * scale));
    return doublings;
}

std::size_t paths_of(const Doublings& doublings) {
    std::size_t paths = 0;
    for (const std::uint8_t d : doublings) paths += std::size_t{1} << d;
    return paths;
}

/// Of so many trials. @param begin  the first. @param pass  counts the rays.
TrialPixels variance_of(EyePass pass, const PilotName& name, std::uint32_t begin,
                        std::uint32_t views) {
    const std::size_t pixels = pass.window.pixels();
    TrialPixels sum(pixels, 0);
    TrialPixels squares(pixels, 0);
    for (std::uint32_t trial = begin; trial < begin + views; ++trial) {
        pass.id = name.round(kPixelTrialsRound).draw(trial);
        PassImage image(pixels, {});
        Statistics unused;
        trace_eye_paths(pass, image, unused);
        const TrialPixels light = luminance_of(image);
        for (std::size_t i = 0; i < pixels; ++i) {
            sum[i] += light[i];
            squares[i] += light[i] * light[i];
        }
    }
    for (std::size_t i = 0; i < pixels; ++i)
        squares[i] = std::max(0.0, squares[i] - sum[i] * sum[i] / views) / (views - 1);
    return told_of_all(squares, pass.window);
}

}  // namespace

double times(const Doublings& doublings, const TrialPixels& pixels) {
    const double one = std::accumulate(pixels.begin(), pixels.end(), 0.0);
    double all = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) all += pixels[i] * (1U << doublings[i]);
    return one > 0 ? all / one : 1;
}

bool PixelTrials::have_noise() const {
    const auto any = [](const TrialPixels& half) {
        return std::any_of(half.begin(), half.end(), [](double v) { return v > 0; });
    };
    return any(variance[0]) && any(variance[1]);
}

PixelTrials trials_of_pixels(const EyePass& first, const PilotName& name, std::uint32_t views) {
    if (views == 0 || first.window.pixels() >= kMostPaths) return {};
    std::vector<std::uint64_t> rays(first.window.pixels(), 0);
    EyePass pass = first;
    pass.rays = rays;
    pass.every = kEvery;
    const std::uint32_t half = views / 2;
    PixelTrials trials{{variance_of(pass, name, 0, half), variance_of(pass, name, half, half)}, {}};
    for (const std::uint64_t n : rays) trials.rays.push_back(static_cast<double>(n) / (2 * half));
    trials.rays = told_of_all(trials.rays, first.window);
    return trials;
}

std::vector<CameraShares> camera_shares(const PixelWindow& window, const PixelTrials& trials,
                                        const TrialPixels& light) {
    std::vector<CameraShares> all;
    if (!trials.have_noise()) return all;
    TrialPixels brightness = smoothed(light, window);
    const double dark = kDarkOfMean * mean_of(brightness);
    if (!(dark > 0)) return all;
    for (double& b : brightness) b = std::max(b, dark);
    const auto& [one, other] = trials.variance;
    TrialPixels steady(one.size());  // a flash that one half has seen is no place for more
    for (std::size_t i = 0; i < one.size(); ++i) steady[i] = std::sqrt(one[i] * other[i]);
    const auto noise = [&](const TrialPixels& variance) {
        return noise_of(variance, trials.rays, brightness);
    };
    const TrialPixels of_both = noise(steady);
    if (!(mean_of(of_both) > 0)) return all;
    const std::array<TrialPixels, 2> of_half = {noise(one), noise(other)};
    for (const double level : kLevels) {
        CameraShares shares{doublings_of(of_both, level), 1, {}};
        if (paths_of(shares.doublings) > kMostPaths) break;
        shares.work = times(shares.doublings, trials.rays);
        for (const std::size_t h : {0U, 1U}) shares.by_half[h] = doublings_of(of_half[h], level);
        all.push_back(std::move(shares));
    }
    return all;
}

Foretold foretold(const CameraShares& shares, const PixelTrials& trials, const BlockGrid& grid,
                  std::size_t block) {
    Foretold sums;
    grid.for_pixels(block, [&](std::size_t i) {
        for (const std::size_t h : {0U, 1U}) {
            sums.even += trials.variance[h][i];
            sums.left += trials.variance[h][i] / (1U << shares.by_half[1 - h][i]);
        }
    });
    const auto terms = static_cast<double>(2 * grid.block(block).pixels());
    return {sums.even / terms, sums.left / terms};
}

}  // namespace sunfleck
