// Ways to share camera paths among pixels: more where their light is noisy.
//
// In:  a pass like an epoch's first. Out: numbers of paths, learned from trial camera paths that
// are no part of a picture, and what they are worth, foretold.
// Source: Neyman's allocation, numbers as the standard deviation over the root of the cost
// (J. Royal Statistical Society 97, 1934).
#pragma once

#include "eye/eye_pass.h"
#include "render/trial_variance.h"
#include "sampler/set_walk.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck {

/// Of one camera path in each pixel, and in those around it, which are alike.
struct PixelTrials {
    /// Of the light that needs no photon, as each half of the trials has seen it.
    std::array<TrialPixels, 2> variance;
    TrialPixels rays;

    /// Have both halves seen any?
    bool have_noise() const;
};

/// None of pictures that have as many pixels as there may be paths.
/// @param views  how many trials, in every other column and row: at least four; or 0, for none.
PixelTrials trials_of_pixels(const EyePass& first, const PilotName& name, std::uint32_t views);

/// A way to share them out.
struct CameraShares {
    Doublings doublings;  // of a draw's camera paths
    double work = 1;      // in rays, over that of one path each
    /// What each half of the trials would have had it be. The other half knows what that is worth.
    std::array<Doublings, 2> by_half;
};

/// A sum over pixels, with so many camera paths over that with one each.
double times(const Doublings& doublings, const TrialPixels& pixels);

/// From few to many more paths than one a pixel: 64 at most, and no more than eight million
/// together, whose points need memory. None where there is no noise.
/// @param light  of the pixels.
std::vector<CameraShares> camera_shares(const PixelWindow& window, const PixelTrials& trials,
                                        const TrialPixels& light);

/// Variance of camera paths in the mean over a block's pixels.
struct Foretold {
    double even = 0;  // with one each
    double left = 0;  // with shares
};

/// Without hindsight: what one half of the trials has seen, where paths go as the other half would
/// have it.
Foretold foretold(const CameraShares& shares, const PixelTrials& trials, const BlockGrid& grid,
                  std::size_t block);

}  // namespace sunfleck
