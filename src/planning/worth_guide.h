// Worth guide: an emission guide of full support for independent photon paths, by what they are
// worth to the picture.
//
// In:  visible points, light that needs no photon. Out: a density of emission. Its first samples
// are of casters; rounds of trials, each through the guide so far, correct it.
// The worth of a path is the sum over pixels of what it brings over the scale of errors there
// (aovs/objective.h): the density of least variance is in proportion to the root of the mean
// squared worth. Where that density is low by chance, a path would be a spot: a bound of
// its weight leaves a small part of all worth to chains (chains/guided_remainder.h).
// Equations: docs/method/sampling.md, eqs. (38), (39) and (42).
#pragma once

#include "aovs/objective.h"
#include "chains/chain_walk.h"
#include "guide/emission_guide.h"
#include "photon/light_stratum.h"
#include "planning/photon_trials.h"

namespace sunfleck::engine {

struct WorthGuide {
    GuidedPlan
        plan;  // of no paths yet; its map is the identity if nothing in the scene bends light
    std::vector<WeightedEmission> bounded;  // where trials of worth started that would weigh more
};

/// @param context  whose camera paths bring what diffuse surfaces send on first
///                 (TransportSettings::goes_beyond_diffuse()).
/// @param seen  the trial that the visible points are of. @param paths  of a pass.
WorthGuide learned_worth_guide(const PhotonContext& context, const PixelWindow& window,
                               const CameraTrial& seen, const PilotName& name, std::uint32_t paths,
                               Objective objective);

}  // namespace sunfleck::engine
