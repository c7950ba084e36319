// Layers of a picture that hold the light of some of the scene's lights alone, so that lamps can be
// dimmed after the render. A light is in at most one of them; emission, direct light and photons
// count alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck {

inline constexpr std::size_t kMostLightLayers = 64;
/// The layer of a light that is in none.
inline constexpr std::uint8_t kNoLightLayer = 0xFF;

struct LightLayers {
    std::vector<std::string> names;      // by layer, at most kMostLightLayers
    std::string text;                    // which lights, as a user wrote it
    std::vector<std::uint8_t> of_light;  // by light of the scene: its layer; empty: all in none

    std::uint8_t of(std::size_t light) const {
        return of_light.empty() ? kNoLightLayer : of_light[light];
    }
};

}  // namespace sunfleck
