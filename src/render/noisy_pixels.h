// Ways to share camera paths among pixels: more where their light is noisy.
//
// In:  an epoch's first pass. Out: numbers of paths, learned from trial camera paths that are no
// part of a picture.
// Source: Neyman's allocation, numbers as the standard deviation over the root of the cost
// (J. Royal Statistical Society 97, 1934).
#pragma once

#include "eye/eye_pass.h"
#include "render/trial_variance.h"
#include "sampler/set_walk.h"

#include <cstdint>
#include <vector>

namespace sunfleck {

/// Of one camera path in each pixel, and in those around it, which are alike.
struct PixelTrials {
    TrialPixels variance;  // of the light that needs no photon
    TrialPixels steady;    // as much of it as both halves of the trials have seen
    TrialPixels rays;

    bool have_noise() const;
};

PixelTrials trials_of_pixels(const EyePass& first, const PilotName& name);

/// Pixel i has 2^doublings[i] camera paths in a draw (see EyePass).
struct CameraShares {
    std::vector<std::uint8_t> doublings;
    double work = 1;  // in rays, over that of one path each
};

/// From few to many more paths than one a pixel, 16 at most. None where there is no noise.
/// @param light  of the pixels.
std::vector<CameraShares> camera_shares(const PixelWindow& window, const PixelTrials& trials,
                                        const TrialPixels& light);

/// The share of a block's variance that is left.
double left_of(const CameraShares& shares, const PixelTrials& trials, const BlockGrid& grid,
               std::size_t block);

}  // namespace sunfleck
