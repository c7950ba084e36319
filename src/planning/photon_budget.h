// How many photon paths, camera paths and subpasses the passes of an epoch have: measured on
// trials, which are no part of a picture.
//
// In:  a view like those of an epoch's passes, and a plan for it. Out: numbers of paths and of
// subpasses. Source: the rule and its constants are measured ones (docs/develop/decisions.md).
#pragma once

#include "planning/photon_trials.h"

namespace sunfleck::engine {

/// How the subpasses of an epoch share their paths.
struct SubpassPlan {
    PhotonBudget budget;
    Log2Samples log2_samples;  // of camera paths: one a pixel if empty
};

/// What is to be measured, and by how much work.
struct SubpassRequest {
    std::uint32_t usual = 0;  // photon paths of a subpass, were nothing measured
    bool budget = true;
    bool shares = true;       // of camera paths
    TrialEffort views;        // that tell where pixels are noisy
    std::uint32_t parts = 4;  // a set of photons is one of so many of the usual paths
    int cells = 1;            // pixels a side, of which one has a path in the second view
};

/// Of the sampler `adaptive`.
/// @param first  a pass like the epoch's first, but no part of the picture.
/// @param seen  its view: what the planner explored.
/// @param plan  of a subpass with the usual paths.
SubpassPlan measured_plan(const CameraPass& first, const CameraTrial& seen,
                          const std::vector<LightStratum>& plan, const PilotName& name,
                          const SubpassRequest& request);

}  // namespace sunfleck::engine
