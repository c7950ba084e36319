// Learning which lights are sampled together, and how.
//
// In:  what is seen in an epoch's first pass. Out: groups of lights with their plans. Pilots are
// never part of a picture (sampler/pilot.h).
#pragma once

#include "photon/photon_group.h"
#include "photon/settings.h"
#include "sampler/pilot.h"

#include <vector>

namespace sunfleck {

/// All lights together, by one ladder. @param paths  of a pass, at least 2.
PhotonGroup learn_one_group(const PhotonView& view, const PhotonSettings& settings,
                            const PilotName& name, std::uint32_t paths);

/// As many groups as the lights' visible fractions ask for (photon/group_rules.h), at least one;
/// one is that of learn_one_group().
std::vector<PhotonGroup> learn_light_groups(const PhotonView& view, const PhotonSettings& settings,
                                            const PilotName& name, std::uint32_t paths);

}  // namespace sunfleck
