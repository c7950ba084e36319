// Light groups: AOVs that hold the light of some lights alone, for mixing after the render.
//
// A light is in at most one group. Emission, direct light and photons count alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

inline constexpr std::size_t kMostLightGroups = 64;
/// The group of a light that is in none.
inline constexpr std::uint8_t kNoLightGroup = 0xFF;

struct LightGroups {
    std::vector<std::string> names;      // by group, at most kMostLightGroups
    std::string text;                    // the lights, as the user wrote them
    std::vector<std::uint8_t> of_light;  // group of each light; empty if no light has one

    std::uint8_t of(std::size_t light) const {
        return of_light.empty() ? kNoLightGroup : of_light[light];
    }
};

}  // namespace sunfleck::engine
