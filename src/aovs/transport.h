// Settings of light transport that camera paths, photon paths and reference integrators share.
#pragma once

#include "aovs/light_groups.h"
#include "core/named_rows.h"

#include <array>
#include <string_view>

namespace sunfleck::engine {

/// Which estimator computes direct light at surfaces that gather.
enum class DirectLight {
    sampled,  // next event estimation of camera paths; photons count from their second hit on
    photons   // photons, from their first hit on
};

/// Which estimator computes light that leaves its lamp straight to a diffuse surface, and comes
/// from there to the diffuse surface that the camera sees.
enum class IndirectLight { automatic, photons, sampled };

inline constexpr std::array<ChoiceRow<IndirectLight>, 3> kIndirectLights = {{
    {IndirectLight::automatic, "auto", "by whichever trials find better"},
    {IndirectLight::photons, "photons", "by photons"},
    {IndirectLight::sampled, "sampled", "by camera paths that go on"},
}};

inline std::string_view name_of(IndirectLight indirect) {
    return kIndirectLights.at(static_cast<std::size_t>(indirect)).name;
}

inline constexpr int kDefaultMaxDepth = 64;

struct TransportSettings {
    DirectLight direct = DirectLight::sampled;
    int max_depth = kDefaultMaxDepth;  // scattering events of a path, camera and light together
    LightGroups light_groups{};
    IndirectLight indirect = IndirectLight::automatic;  // where direct light is sampled

    /// Returns whether camera paths go on beyond the first diffuse surface.
    bool goes_beyond_diffuse() const {
        return direct == DirectLight::sampled && indirect == IndirectLight::sampled;
    }
};

}  // namespace sunfleck::engine
