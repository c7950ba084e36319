// Adaptive pixel sampling: allocations of camera paths to pixels by their noise.
//
// In:  trials of the pixels. Out: numbers of paths, with predicted variance.
// Source: Neyman allocation, in proportion to standard deviation over the root of the cost (J.
// Royal Statistical Society 97, 1934); here with the variance decay of scrambled nets.
// Equations: docs/method/sampling.md, eq. (19).
#pragma once

#include "aovs/objective.h"
#include "film/luminance.h"
#include "planning/pixel_trials.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// An allocation of camera paths.
struct CameraShares {
    Log2Samples log2_samples;  // of a pass
    double work = 1;           // in rays, over that of one path per pixel
    /// Allocations computed from one half of the trials each; the other half scores them
    /// (cross-validation).
    std::array<Log2Samples, 2> by_half;

    unsigned log2_samples_of(std::size_t pixel) const {
        return log2_samples.empty() ? 0 : log2_samples[pixel];
    }
};

/// Returns the weighted mean number of camera paths per pixel; one if all weights are zero.
double mean_paths(const Log2Samples& log2_samples, const PixelValues& weights);

/// Returns the limit of camera paths of a pass, over all pixels.
std::uint64_t most_camera_paths(std::uint64_t pixels);

/// Returns whether there are enough pixels for allocations, and not too many for the memory of more
/// paths.
bool may_be_shared(const PixelWindow& window);

/// Returns allocations from few to many more paths than one per pixel: at most 64 per pixel, and at
/// most eight million in total, because visible points need memory. Empty without noise.
/// @param light  of the pixels.
std::vector<CameraShares> camera_shares(const PixelWindow& window, const PixelTrials& trials,
                                        const PixelValues& light, Objective objective);

/// Returns the variance of light that needs no photon, as the mean over a block's pixels, with
/// paths allocated by the other half of the trials (cross-validation).
double remaining_variance(const CameraShares& shares, const PixelTrials& trials,
                          const BlockGrid& grid, std::size_t block);

}  // namespace sunfleck::engine
