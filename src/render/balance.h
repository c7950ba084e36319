// How many photon paths, camera paths and draws the passes of an epoch have: measured on trials,
// which are no part of a picture.
//
// In:  a view like those of an epoch's passes, and a plan for it. Out: numbers of paths and of
// draws. Source: the rule and its constants are measured ones (docs/decisions.md).
#pragma once

#include "eye/eye_pass.h"
#include "photon/photon_group.h"
#include "render/balance_rule.h"
#include "render/noisy_pixels.h"
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
    Doublings doublings;  // of camera paths: one a pixel if empty
};

/// What is to be measured, and by how much work.
struct DrawWishes {
    std::uint32_t usual = 0;  // photon paths of a draw, were nothing measured
    bool balance = true;
    std::uint32_t views = 8;  // that tell where pixels are noisy: see trials_of_pixels()
    std::uint32_t parts = 4;  // a set of photons is one of so many of the usual paths
    int every = 1;            // the second view has so many columns and rows: 1 or 2
};

/// Of the sampler `adaptive`.
/// @param first  a pass like the epoch's first, but no part of the picture.
/// @param seen  its view: what the planner explored.
/// @param plan  of a draw with the usual paths.
DrawPlan measured_plan(const EyePass& first, const EyeView& seen,
                       const std::vector<PhotonGroup>& plan, const PilotName& name,
                       const DrawWishes& wishes);

/// The same sets and maps, with one of so many parts of the paths and chains: what a trial measures
/// holds for it, as it would not for a ladder planned anew for few paths.
std::vector<PhotonGroup> part_of(std::vector<PhotonGroup> groups, std::uint32_t parts);

}  // namespace sunfleck
