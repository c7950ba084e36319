// Measurement of the paths of an epoch: photon paths, camera paths and subpasses per pass, from
// trials that are no part of a picture.
//
// In:  visible points like those of the epoch's passes, and a plan. Out: numbers of paths and
// subpasses.
// Source: the rule and its constants are measured (docs/develop/decisions.md).
#pragma once

#include "planning/photon_trials.h"

namespace sunfleck::engine {

/// The numbers of paths of the subpasses of an epoch.
struct SubpassPlan {
    PhotonBudget budget;
    Log2Samples log2_samples;  // of camera paths: one per pixel if empty
};

/// What to measure, and with how much work.
struct SubpassRequest {
    std::uint32_t usual = 0;  // photon paths of a subpass by default
    Objective objective = Objective::relative;
    bool budget = true;
    bool shares = true;       // adaptive pixel sampling
    TrialEffort trials;       // trials that measure the noise of pixels
    std::uint32_t parts = 4;  // a set of photons has 1 / parts of the usual paths
    int cells = 1;            // the second trial has one path per cells x cells pixels
};

/// Measures the plan of the sampler `adaptive`.
/// @param first  a pass like the epoch's first, but no part of the picture.
/// @param seen  its trial, which the planner explored.
/// @param plan  of a subpass with the usual paths.
SubpassPlan measured_plan(const CameraPass& first, const CameraTrial& seen,
                          const std::vector<LightStratum>& plan, const PilotName& name,
                          const SubpassRequest& request);

}  // namespace sunfleck::engine
