// Variances of camera paths and of photon paths, from trial passes.
//
// In:  two views with other camera paths, both lit by the same two sets of photons. Out: variances
// by block. What differs between the views, and alike for both sets, is the camera paths' part.
// What differs between the sets is the photons': alike in both views it stays, however many camera
// paths a pixel has; else it is of where their points lie, and several have less of it.
// Source: covariance of independent replicates.
#pragma once

#include "film/luminance.h"
#include "planning/adaptive_pixels.h"
#include "planning/budget_allocation.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

inline constexpr std::uint32_t kPhotonSets = 2;  // that light both views

/// One view's trial passes, pixel by pixel.
struct Trial {
    PixelValues camera;                        // light that needs no photon
    std::array<PixelValues, kPhotonSets> lit;  // all light, with each set of photons
};

struct TrialPair {
    Trial one;
    Trial other;
    int cells = 1;     // pixels a side, of which one has light in the other view
    double paths = 1;  // photon paths of a set
};

/// Of the blocks that are brighter than 1% of the picture: unbiased but for the division by their
/// measured brightness. All of them in the order of the grid.
/// @param shares  that the subpasses would have; where noise is `trials` told them, never the pair.
std::vector<BlockVariance> block_variances(const PixelWindow& window, const TrialPair& pair,
                                           const PixelTrials& trials, const CameraShares& shares);

}  // namespace sunfleck::engine
