// RGB colour spaces of scene files, and their conversion to linear sRGB.
//
// Source of the primaries: SMPTE EG 432-1 (P3, here under D65 as in pbrt-v4), ITU-R BT.2020, SMPTE
// ST 2065-1. Source of the adaptation: Lam and Rigg, Bradford (1985), with Lindbloom's numbers.
#pragma once

#include "math/colour.h"

#include <optional>
#include <string_view>

namespace sunfleck::engine {

enum class ColourSpace { srgb, dci_p3, rec2020, aces2065_1 };

/// Finds a colour space by pbrt-v4's name, in lower or upper case.
std::optional<ColourSpace> colour_space(std::string_view name);

/// Converts the colour of a light: it looks the same in sRGB. Components may be negative.
Triple srgb_of_light(ColourSpace space, const Triple& rgb);

/// Converts the colour of a surface: a surface that is white in its space is white under D65.
Triple srgb_of_surface(ColourSpace space, const Triple& rgb);

}  // namespace sunfleck::engine
