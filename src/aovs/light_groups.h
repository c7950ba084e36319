// Light groups: outputs of a picture that hold the light of some of the scene's lights alone, so
// that lamps can be dimmed after the render. A light is in at most one of them; emission, direct
// light and photons count alike.
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
    std::string text;                    // which lights, as a user wrote it
    std::vector<std::uint8_t> of_light;  // by light of the scene: its group; empty: all in none

    std::uint8_t of(std::size_t light) const {
        return of_light.empty() ? kNoLightGroup : of_light[light];
    }
};

}  // namespace sunfleck::engine
