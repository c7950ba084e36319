// Choices that camera paths, photon paths and reference integrators share: who brings which light,
// and where it counts.
#pragma once

#include "aovs/light_groups.h"

namespace sunfleck::engine {

/// Who brings the light that comes straight from an emitter to a surface that gathers.
enum class DirectLight {
    sampled,  // the camera path samples it; photons count from their second hit on
    photons   // photons bring it too
};

inline constexpr int kDefaultMaxDepth = 64;

struct TransportSettings {
    DirectLight direct = DirectLight::sampled;
    int max_depth =
        kDefaultMaxDepth;  // scattering events on a whole path, camera and light together
    LightGroups light_groups{};
};

}  // namespace sunfleck::engine
