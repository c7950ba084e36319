// LightPlanner: learns which lights are sampled together in strata, and how.
//
// In:  visible points like those of an epoch's first pass. Out: light strata with their plans.
// Pilots are no part of a picture (chains/pilot.h).
#pragma once

#include "chains/pilot.h"
#include "photon/light_stratum.h"
#include "photon/settings.h"

#include <memory>
#include <vector>

namespace sunfleck::engine {

/// Explores once, then plans for any number of paths.
class LightPlanner {
public:
    /// @param photon_context, settings  must outlive this.
    /// @param work  camera and photon paths of the planned passes: the limit of a long guide
    /// search.
    LightPlanner(const PhotonContext& photon_context, const PhotonSettings& settings,
                 const PilotName& name, std::uint64_t work);
    LightPlanner(const LightPlanner&) = delete;
    LightPlanner(LightPlanner&&) = delete;
    LightPlanner& operator=(const LightPlanner&) = delete;
    LightPlanner& operator=(LightPlanner&&) = delete;
    ~LightPlanner();

    /// Returns as many strata as the visible fractions require (photon/stratum_rules.h), at least
    /// one. @param paths  per pass, at least 2.
    std::vector<LightStratum> plan(std::uint32_t paths);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sunfleck::engine
