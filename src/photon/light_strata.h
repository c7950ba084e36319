// Learning which lights are sampled together, and how.
//
// In:  a view like that of an epoch's first pass. Out: strata of lights with their plans. Pilots
// are never part of a picture (chains/pilot.h).
#pragma once

#include "chains/pilot.h"
#include "photon/light_stratum.h"
#include "photon/settings.h"

#include <memory>
#include <vector>

namespace sunfleck::engine {

/// Explores once, plans for any number of paths.
class LightPlanner {
public:
    /// @param view, settings  must outlive it. @param work  camera and photon paths of the passes
    ///                        that plans are for: a long search for light costs no more.
    LightPlanner(const PhotonContext& view, const PhotonSettings& settings, const PilotName& name,
                 std::uint64_t work);
    LightPlanner(const LightPlanner&) = delete;
    LightPlanner(LightPlanner&&) = delete;
    LightPlanner& operator=(const LightPlanner&) = delete;
    LightPlanner& operator=(LightPlanner&&) = delete;
    ~LightPlanner();

    /// As many strata as the lights' visible fractions ask for (photon/stratum_rules.h), at least
    /// one. @param paths  of a pass, at least 2.
    std::vector<LightStratum> plan(std::uint32_t paths);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sunfleck::engine
