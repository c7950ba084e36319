// Allocation of paths by the noise of trials.
#include "planning/adaptive_pixels.h"

#include "core/parallel.h"
#include "planning/judged_blocks.h"
#include "planning/pixel_tuning.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns judged variance per cost of a path.
PixelValues worth_of(const PixelValues& variance, const PixelValues& rays,
                     const PixelValues& scale) {
    PixelValues worth(variance.size());
    for (std::size_t i = 0; i < worth.size(); ++i) worth[i] = variance[i] / (rays[i] * scale[i]);
    return worth;
}

/// Returns the log2 samples whose last doubling still pays. @param worth  relative to one path.
std::uint8_t log2_samples_for(double worth, const VarianceDecay& net) {
    std::uint8_t log2_samples = 0;
    double gain = worth * (1 - net.doubling);
    while (log2_samples < kMostLog2Samples && gain >= 1) {
        gain *= net.doubling / 2;
        ++log2_samples;
    }
    return log2_samples;
}

/// @param level  paths of a pixel of mean noise.
Log2Samples log2_samples_of(const PixelValues& worth, const PixelTrials& trials,
                            const BlockGrid& grid, double level) {
    double noise = 0;
    for (const double w : worth) noise += std::sqrt(w);
    noise /= level * static_cast<double>(worth.size());
    Log2Samples log2_samples(worth.size());
    parallel_for(grid.count(), [&](std::size_t block) {
        grid.for_pixels(block, [&](std::size_t i) {
            log2_samples[i] = log2_samples_for(worth[i] / (noise * noise), trials.nets[block]);
        });
    });
    return log2_samples;
}

std::size_t paths_of(const Log2Samples& log2_samples) {
    std::size_t paths = 0;
    for (const std::uint8_t d : log2_samples) paths += std::size_t{1} << d;
    return paths;
}

}  // namespace

double mean_paths(const Log2Samples& log2_samples, const PixelValues& weights) {
    const double weight = std::accumulate(weights.begin(), weights.end(), 0.0);
    double paths = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) paths += weights[i] * (1U << log2_samples[i]);
    return weight > 0 ? paths / weight : 1;
}

std::uint64_t most_camera_paths(std::uint64_t pixels) {
    const auto at_level = static_cast<std::uint64_t>(kAllocationLevels.back()) * pixels;
    return std::max<std::uint64_t>(pixels, std::min<std::uint64_t>(at_level, kMostCameraPaths));
}

bool may_be_shared(const PixelWindow& window) {
    return window.pixels() < kMostCameraPaths;
}

std::vector<CameraShares> camera_shares(const PixelWindow& window, const PixelTrials& trials,
                                        const PixelValues& light, Objective objective) {
    std::vector<CameraShares> all;
    if (!trials.have_noise()) return all;
    if (!(mean_value(light) > 0)) return all;
    const PixelValues scale = squared_scales(window, light, objective);
    const auto& [one, other] = trials.variance;
    PixelValues steady(one.size());  // outliers in one half attract no paths
    for (std::size_t i = 0; i < one.size(); ++i) steady[i] = std::sqrt(one[i] * other[i]);
    const auto worth = [&](const PixelValues& variance) {
        return worth_of(variance, trials.rays, scale);
    };
    const PixelValues of_both = worth(steady);
    if (!(mean_value(of_both) > 0)) return all;
    const std::array<PixelValues, 2> of_half = {worth(one), worth(other)};
    const BlockGrid grid(window.width(), window.height(), kTrialBlock);
    for (const double level : kAllocationLevels) {
        CameraShares shares{log2_samples_of(of_both, trials, grid, level), 1, {}};
        if (paths_of(shares.log2_samples) > kMostCameraPaths) break;
        shares.work = mean_paths(shares.log2_samples, trials.rays);
        for (const std::size_t h : {0U, 1U})
            shares.by_half[h] = log2_samples_of(of_half[h], trials, grid, level);
        all.push_back(std::move(shares));
    }
    return all;
}

double remaining_variance(const CameraShares& shares, const PixelTrials& trials,
                          const BlockGrid& grid, std::size_t block) {
    double sum = 0;
    for (const std::size_t h : {0U, 1U}) {
        const Log2Samples& log2_samples = shares.by_half[1 - h];
        grid.for_pixels(block, [&](std::size_t i) {
            sum += trials.variance[h][i] *
                   trials.nets[block].left(log2_samples.empty() ? 0U : log2_samples[i]);
        });
    }
    return sum / static_cast<double>(2 * grid.block(block).pixels());
}

}  // namespace sunfleck::engine
