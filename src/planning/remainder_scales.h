// Mutation scales of the chains that bring what guided paths of bounded weight leave.
#pragma once

#include "chains/chain_walk.h"
#include "photon/light_stratum.h"

#include <vector>

namespace sunfleck::engine {

/// Runs chains until their scales hardly change.
/// @param guided  with a most weight. @param starts  where visible paths start that would weigh
/// more.
MutationScales remainder_scales(const PhotonContext& context, const LightChoice& lights,
                                const GuidedPlan& guided,
                                const std::vector<WeightedEmission>& starts, const PilotName& name);

}  // namespace sunfleck::engine
