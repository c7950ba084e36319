// Settings of light transport that camera paths, photon paths and reference integrators share.
#pragma once

#include "aovs/light_groups.h"

namespace sunfleck::engine {

/// Which estimator computes direct light at surfaces that gather.
enum class DirectLight {
    sampled,  // next event estimation of camera paths; photons count from their second hit on
    photons   // photons, from their first hit on
};

inline constexpr int kDefaultMaxDepth = 64;

struct TransportSettings {
    DirectLight direct = DirectLight::sampled;
    int max_depth = kDefaultMaxDepth;  // scattering events of a path, camera and light together
    LightGroups light_groups{};
};

}  // namespace sunfleck::engine
