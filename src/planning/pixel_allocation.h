// Choice of the camera paths of an epoch's pixels, by trials that are no part of a picture.
//
// In:  visible points like those of the epoch's passes, and a plan. Out: numbers of paths, of the
// allocation with least error.
// Source: the rule and its constants are measured (docs/develop/decisions.md).
// Equations: docs/method/sampling.md, eqs. (20) and (22).
#pragma once

#include "planning/photon_trials.h"
#include "planning/pixel_tuning.h"

namespace sunfleck::engine {

/// How much work trials do, and what they judge.
struct AllocationRequest {
    Objective objective = Objective::relative;
    TrialEffort pixels;                     // trials that measure the noise of pixels
    std::uint32_t parts = kPartsOfPhotons;  // a set of photons has 1 / parts of a pass's paths
    int cells = 1;  // the second trial has one path per cells x cells pixels
};

/// Returns the allocation with least error per work; empty if that is one path per pixel.
/// @param first  a pass like the epoch's first, but no part of the picture.
/// @param seen  its trial, which the planner explored.
/// @param plan  of a pass.
Log2Samples chosen_allocation(const CameraPass& first, const CameraTrial& seen,
                              const std::vector<LightStratum>& plan, const PilotName& name,
                              const AllocationRequest& request);

/// Returns the judged standard error of a pass times the root of its work, summed over blocks: in a
/// mean of variances few noisy blocks would dominate.
/// @param paths  photon paths of the pass.
double error_of_pass(const std::vector<BlockVariance>& blocks, double paths, double work);

}  // namespace sunfleck::engine
