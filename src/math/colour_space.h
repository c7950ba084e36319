// Spaces of rgb that scenes may give their colours in, and what they are in linear sRGB.
//
// Source of the primaries: SMPTE EG 432-1 (P3, here under D65 as in pbrt-v4), ITU-R BT.2020,
// SMPTE ST 2065-1; of the adaptation: Lam and Rigg, Bradford (1985), by Lindbloom's numbers.
#pragma once

#include "math/colour.h"

#include <optional>
#include <string_view>

namespace sunfleck::engine {

enum class ColourSpace { srgb, dci_p3, rec2020, aces2065_1 };

/// By pbrt-v4's names, in small letters or large ones.
std::optional<ColourSpace> colour_space(std::string_view name);

/// Linear sRGB of a light of that colour: it looks the same. Components may be negative.
Triple srgb_of_light(ColourSpace space, const Triple& rgb);

/// Linear sRGB of a surface: what is white under the white of its space is white under D65.
Triple srgb_of_surface(ColourSpace space, const Triple& rgb);

}  // namespace sunfleck::engine
