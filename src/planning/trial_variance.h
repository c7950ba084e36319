// Variances of camera paths and of photon paths, separated by trial passes.
//
// In:  two trials with different camera paths, both lit by the same two sets of photons. Out:
// variances per block. A difference between trials that is the same for both sets is due to camera
// paths. A difference between sets is due to photons: the part that both trials share remains,
// however many camera paths a pixel has; the rest depends on the positions of visible points, and
// several paths reduce it.
// Source: covariance of independent replicates.
// Equations: docs/method/sampling.md, eq. (21).
#pragma once

#include "aovs/objective.h"
#include "film/luminance.h"
#include "planning/adaptive_pixels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

inline constexpr std::uint32_t kPhotonSets = 2;  // both trials use them

/// Variances of a block of pixels in one pass, as the objective judges them. They are estimates,
/// and may be negative.
struct BlockVariance {
    double camera = 0;  // of camera paths: photons do not reduce it
    double photon = 0;  // of one photon path: n paths have 1/n of it
};

/// Light of one trial per pixel.
struct Trial {
    PixelValues camera;                        // light that needs no photon
    std::array<PixelValues, kPhotonSets> lit;  // all light, with each set of photons
};

struct TrialPair {
    Trial one;
    Trial other;
    int cells = 1;     // the other trial has one path per cells x cells pixels
    double paths = 1;  // photon paths of a set
};

/// Returns the variances of blocks, in grid order: unbiased, except for the division by measured
/// brightness. Empty if the picture is black.
/// @param shares  allocation of the pass, computed from `trials`, never from the pair.
std::vector<BlockVariance> block_variances(const PixelWindow& window, const TrialPair& pair,
                                           const PixelTrials& trials, const CameraShares& shares,
                                           Objective objective);

}  // namespace sunfleck::engine
