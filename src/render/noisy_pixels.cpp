// Trial views, their spread pixel by pixel, and numbers of paths for it.
#include "render/noisy_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace sunfleck {
namespace {

constexpr std::uint32_t kNoiseRound = 499;  // of the pilots' numbers: beyond all that they use
constexpr std::uint32_t kTrials = 8;        // views
constexpr int kEvery = 2;                   // columns and rows that have any
constexpr double kDarkOfMean = 0.1;         // of the mean brightness: what is darker counts as that
constexpr std::uint8_t kMostDoublings = 4;
/// Paths of a pixel of mean noise, were all numbers allowed.
constexpr std::array<double, 6> kLevels = {0.125, 0.25, 0.5, 1, 2, 4};

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
    const auto some = [](int n) { return (n + kEvery - 1) / kEvery; };
    Raster all(window.width(), window.height());
    Raster few(some(all.width), some(all.height));
    for (int y = 0; y < few.height; ++y)
        for (int x = 0; x < few.width; ++x)
            few.at(x, y) = pixels[all.index(x * kEvery, y * kEvery)];
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

/// @param scale  one over the noise of a pixel with one path.
CameraShares shares_for(const TrialPixels& noise, const TrialPixels& rays, double scale) {
    CameraShares shares{{}, 0};
    shares.doublings.reserve(noise.size());
    for (std::size_t i = 0; i < noise.size(); ++i) {
        shares.doublings.push_back(doublings_for(noise[i] * scale));
        shares.work += rays[i] * (1U << shares.doublings.back());
    }
    shares.work /= mean_of(rays) * static_cast<double>(rays.size());
    return shares;
}

/// Of half of the trials. @param begin  the first. @param pass  counts the rays.
TrialPixels variance_of(EyePass pass, const PilotName& name, std::uint32_t begin) {
    constexpr std::uint32_t kViews = kTrials / 2;
    const std::size_t pixels = pass.window.pixels();
    TrialPixels sum(pixels, 0);
    TrialPixels squares(pixels, 0);
    for (std::uint32_t trial = begin; trial < begin + kViews; ++trial) {
        pass.id = name.round(kNoiseRound).draw(trial);
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
        squares[i] = std::max(0.0, squares[i] - sum[i] * sum[i] / kViews) / (kViews - 1);
    return told_of_all(squares, pass.window);
}

}  // namespace

bool PixelTrials::have_noise() const {
    return std::any_of(steady.begin(), steady.end(), [](double v) { return v > 0; });
}

PixelTrials trials_of_pixels(const EyePass& first, const PilotName& name) {
    std::vector<std::uint64_t> rays(first.window.pixels(), 0);
    EyePass pass = first;
    pass.rays = rays;
    pass.every = kEvery;
    const TrialPixels one = variance_of(pass, name, 0);
    const TrialPixels other = variance_of(pass, name, kTrials / 2);
    PixelTrials trials{TrialPixels(one.size()), TrialPixels(one.size()), TrialPixels(one.size())};
    for (std::size_t i = 0; i < one.size(); ++i) {
        trials.variance[i] = (one[i] + other[i]) / 2;
        trials.steady[i] = std::sqrt(one[i] * other[i]);
        trials.rays[i] = static_cast<double>(rays[i]) / kTrials;
    }
    trials.rays = told_of_all(trials.rays, first.window);
    return trials;
}

std::vector<CameraShares> camera_shares(const PixelWindow& window, const PixelTrials& trials,
                                        const TrialPixels& light) {
    TrialPixels noise = smoothed(light, window);
    const double dark = kDarkOfMean * mean_of(noise);
    for (std::size_t i = 0; i < noise.size(); ++i) {
        const double brightness = std::max(noise[i], dark);
        noise[i] = brightness > 0 ? std::sqrt(trials.steady[i] / trials.rays[i]) / brightness : 0;
    }
    std::vector<CameraShares> all;
    const double mean = mean_of(noise);
    if (!(mean > 0)) return all;
    for (const double level : kLevels) all.push_back(shares_for(noise, trials.rays, level / mean));
    return all;
}

double left_of(const CameraShares& shares, const PixelTrials& trials, const BlockGrid& grid,
               std::size_t block) {
    double before = 0;
    double after = 0;
    grid.for_pixels(block, [&](std::size_t i) {
        before += trials.variance[i];
        after += trials.variance[i] / (1U << shares.doublings[i]);
    });
    return before > 0 ? after / before : 1;
}

}  // namespace sunfleck
