// How many photon paths, camera paths and draws the passes of an epoch have: measured on trials,
// which are no part of a picture.
//
// In:  a view like those of an epoch's passes, and a plan for it. Out: numbers of paths and of
// draws. Source: the rule and its constants are measured ones (docs/decisions.md).
#pragma once

#include "planning/photon_trials.h"

namespace sunfleck {

/// How the draws of an epoch share their paths.
struct DrawPlan {
    Balance balance;
    Doublings doublings;  // of camera paths: one a pixel if empty
};

/// What is to be measured, and by how much work.
struct DrawWishes {
    std::uint32_t usual = 0;  // photon paths of a draw, were nothing measured
    bool balance = true;
    bool shares = true;       // of camera paths
    TrialViews views;         // that tell where pixels are noisy
    std::uint32_t parts = 4;  // a set of photons is one of so many of the usual paths
    int cells = 1;            // pixels a side, of which one has a path in the second view
};

/// Of the sampler `adaptive`.
/// @param first  a pass like the epoch's first, but no part of the picture.
/// @param seen  its view: what the planner explored.
/// @param plan  of a draw with the usual paths.
DrawPlan measured_plan(const EyePass& first, const EyeView& seen,
                       const std::vector<PhotonGroup>& plan, const PilotName& name,
                       const DrawWishes& wishes);

}  // namespace sunfleck
