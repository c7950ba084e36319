// Two views of a scene, both lit by the same two sets of photons, and what these cost.
//
// In:  a pass like an epoch's first and its view, a plan. Out: light, pixel by pixel, and counts;
// no part of a picture.
#pragma once

#include "chains/chain_walk.h"
#include "estimate/photon_counts.h"
#include "photon_samplers/model.h"
#include "planning/trial_variance.h"

#include <vector>

namespace sunfleck::engine {

/// What the camera paths of a pass brought.
struct CameraTrial {
    PassImage image;  // light that needs no photon
    Statistics counts;
    VisiblePointIndex index;
};

CameraTrial view_of(const CameraPass& pass);

/// The same level sets and guides, with one of so many parts of the paths and chains: what a trial
/// measures holds for it, as it would not for levels planned anew for few paths.
std::vector<LightStratum> part_of(std::vector<LightStratum> strata, std::uint32_t parts);

struct PhotonTrials {
    TrialPair pair;
    PhotonTotals totals;  // of both sets
    PixelValues taken;    // photons of both sets, by pixel of the first view
    double deposits = 0;  // of those
};

/// @param second  the other view's pass. @param strata  the photons of a set.
PhotonTrials photon_trials(const CameraPass& second, const CameraTrial& seen,
                           const std::vector<LightStratum>& strata, const PilotName& name);

}  // namespace sunfleck::engine
