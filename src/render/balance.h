// How many photon paths and draws the passes of an epoch have: measured on trials, which are no
// part of a picture.
//
// In:  an epoch's first view, and a planner that explored it. Out: numbers of paths and of draws.
// Source: the rule and its constants are measured ones (docs/decisions.md).
#pragma once

#include "eye/eye_pass.h"
#include "photon/light_groups.h"
#include "render/balance_rule.h"

namespace sunfleck {

/// What the camera paths of a pass brought.
struct EyeView {
    PassImage image;  // light that needs no photon
    Statistics counts;
    VisiblePointIndex index;
};

EyeView view_of(const EyePass& pass);

/// Of the sampler `adaptive`.
/// @param first  the epoch's first pass. @param seen  its view: what the planner explored.
/// @param usual  paths of a draw, were nothing measured.
Balance measured_balance(const EyePass& first, const EyeView& seen, LightPlanner& planner,
                         const PilotName& name, std::uint32_t usual);

}  // namespace sunfleck
