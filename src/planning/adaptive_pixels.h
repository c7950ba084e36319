// Ways to share camera paths among pixels: more where their light is noisy.
//
// In:  trials of the pixels. Out: numbers of paths, and what they are worth, foretold.
// Source: Neyman's allocation, numbers as the standard deviation over the root of the cost
// (J. Royal Statistical Society 97, 1934); here of variances that fall as nets have them.
#pragma once

#include "film/luminance.h"
#include "planning/pixel_trials.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// A way to share them out.
struct CameraShares {
    Log2Samples log2_samples;  // of a subpass's camera paths
    double work = 1;           // in rays, over that of one path each
    /// What each half of the trials would have had it be. The other half knows what that is worth.
    std::array<Log2Samples, 2> by_half;

    unsigned log2_samples_of(std::size_t pixel) const {
        return log2_samples.empty() ? 0 : log2_samples[pixel];
    }
};

/// The mean number of camera paths of a pixel, pixels weighed so; one if all weights are zero.
double mean_paths(const Log2Samples& log2_samples, const PixelValues& weights);

/// Camera paths of a subpass, at most, all pixels together.
std::uint64_t most_camera_paths(std::uint64_t pixels);

/// Are there pixels enough for shares, and not so many that there is no memory for more paths?
bool may_be_shared(const PixelWindow& window);

/// From few to many more paths than one a pixel: 64 at most, and no more than eight million
/// together, whose points need memory. None where there is no noise.
/// @param light  of the pixels.
std::vector<CameraShares> camera_shares(const PixelWindow& window, const PixelTrials& trials,
                                        const PixelValues& light);

/// Variance of the light that needs no photon, in the mean over a block's pixels; without
/// hindsight: what one half of the trials has seen, where paths go as the other half would have it.
double remaining_variance(const CameraShares& shares, const PixelTrials& trials,
                          const BlockGrid& grid, std::size_t block);

}  // namespace sunfleck::engine
