// Worth guide: an emission guide of full support for independent photon paths, by what they are
// worth to the picture.
//
// In:  visible points, light that needs no photon, rounds of earlier epochs. Out: a density of
// emission. Its first samples are of casters; rounds of trials correct it, the first one through
// boxes that chains have learned, the others each through the guide so far.
// The worth of a path is the sum over pixels of what it brings over the scale of errors there
// (aovs/objective.h): the density of least variance is in proportion to the root of the mean
// squared worth. Where that density is low by chance, a path would be a spot: a bound of
// its weight leaves a small part of all worth to chains (chains/guided_remainder.h).
// Equations: docs/method/sampling.md, eqs. (38), (39) and (42).
#pragma once

#include "chains/chain_walk.h"
#include "guide/emission_guide.h"
#include "photon/light_stratum.h"
#include "planning/photon_trials.h"
#include "planning/worth_rounds.h"

#include <memory>

namespace sunfleck::engine {

struct WorthGuide {
    GuidedPlan
        plan;  // of no paths yet; its map is the identity if nothing in the scene bends light
    std::vector<WeightedEmission> bounded;  // where trials of worth started that would weigh more
    std::shared_ptr<const WorthRounds> rounds;  // for the epochs after this; absent with no guide
};

/// Where trials begin.
struct WorthStart {
    std::shared_ptr<const WorthRounds> earlier;  // of the epoch before; absent for the first
    EmissionGuide boxes;  // where chains have found visible paths; the identity if nobody knows
};

struct WorthRequest {
    std::uint32_t paths = 0;  // of a pass
    Objective objective = Objective::relative;
    WorthStart start;
};

/// @param context  whose camera paths bring what diffuse surfaces send on first
///                 (TransportSettings::goes_beyond_diffuse()).
/// @param seen  the trial that the visible points are of. @param name  with the epoch.
WorthGuide learned_worth_guide(const PhotonContext& context, const PixelWindow& window,
                               const CameraTrial& seen, const PilotName& name,
                               const WorthRequest& request);

}  // namespace sunfleck::engine
