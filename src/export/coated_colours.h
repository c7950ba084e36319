// Colours of what lies under a coat.
#pragma once

#include "material/material.h"

#include <optional>

namespace sunfleck::engine {

/// What stands for a coated surface whose base sends a given share of the entered light out again.
struct CoatedColour {
    SpectrumTexture colour;
    bool has_coat = true;  // else `colour` is that of a diffuse surface without the coat
};

/// Returns the reflectance of the base alone. Where it would exceed one, because a rough coat loses
/// light, it is that of a diffuse surface that reflects as much of diffuse light as base and coat
/// together. Pictures are changed texel by texel.
/// @param whole  share of the light that has entered the coat which leaves it again.
/// @return nothing for textures other than constants and plain pictures.
std::optional<CoatedColour> coated_colour(const Coat& coat, const SpectrumTexture& whole);

}  // namespace sunfleck::engine
