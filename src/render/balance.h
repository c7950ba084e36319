// How many photon paths, camera paths and draws the passes of an epoch have: measured on trials,
// which are no part of a picture.
//
// In:  an epoch's first view, and a plan for it. Out: numbers of paths and of draws.
// Source: the rule and its constants are measured ones (docs/decisions.md).
#pragma once

#include "eye/eye_pass.h"
#include "photon/photon_group.h"
#include "render/balance_rule.h"
#include "sampler/set_walk.h"

namespace sunfleck {

/// What the camera paths of a pass brought.
struct EyeView {
    PassImage image;  // light that needs no photon
    Statistics counts;
    VisiblePointIndex index;
};

EyeView view_of(const EyePass& pass);

/// How the draws of an epoch share their paths.
struct DrawPlan {
    Balance balance;
    std::vector<std::uint8_t> doublings;  // of camera paths: see EyePass
};

/// What is to be measured.
struct DrawWishes {
    std::uint32_t usual = 0;  // photon paths of a draw, were nothing measured
    bool balance = true;
    bool shares = true;  // of camera paths
};

/// Of the sampler `adaptive`.
/// @param first  the epoch's first pass. @param seen  its view: what the planner explored.
/// @param plan  of a draw with the usual paths.
DrawPlan measured_plan(const EyePass& first, const EyeView& seen,
                       const std::vector<PhotonGroup>& plan, const PilotName& name,
                       const DrawWishes& wishes);

/// The same sets and maps, with one of so many parts of the paths and chains: what a trial measures
/// holds for it, as it would not for a ladder planned anew for few paths.
std::vector<PhotonGroup> part_of(std::vector<PhotonGroup> groups, std::uint32_t parts);

}  // namespace sunfleck
