// Photon trials: two trials of a scene, lit by the same two sets of photons, with their cost.
//
// In:  a pass like an epoch's first and its trial, a plan. Out: light per pixel, and counts. They
// are no part of a picture.
#pragma once

#include "aovs/statistics.h"
#include "chains/chain_walk.h"
#include "estimate/photon_counts.h"
#include "photon/light_stratum.h"
#include "planning/trial_variance.h"

#include <vector>

namespace sunfleck::engine {

/// The results of a trial's camera paths.
struct CameraTrial {
    PassImage image;  // light that needs no photon
    Statistics counts;
    VisiblePointIndex index;
    int cells = 1;              // one path per cells x cells pixels
    std::vector<Lit> lit = {};  // by pixel, where photons may share the direct light of media
};

CameraTrial view_of(const CameraPass& pass);

/// Returns the pixels that each path of a trial stands for. @param cells  of the trial.
inline double pixels_of_a_path(int cells) {
    return static_cast<double>(cells) * cells;
}

/// Returns the same level sets and guides with 1 / parts of the paths and chains: measurements then
/// hold for the full plan, which new levels for few paths would not allow.
std::vector<LightStratum> fraction_of(std::vector<LightStratum> strata, std::uint32_t parts);

struct PhotonTrials {
    TrialPair pair;
    PixelValues taken;              // accepted photons of both sets, by pixel of the first trial
    double deposits = 0;            // of those
    std::uint64_t photon_rays = 0;  // of both sets
};

/// @param second  the pass of the other trial. @param strata  of one set of photons.
PhotonTrials photon_trials(const CameraPass& second, const CameraTrial& seen,
                           const std::vector<LightStratum>& strata, const PilotName& name);

}  // namespace sunfleck::engine
