// Colours of metal under a thin film.
#pragma once

#include "material/material.h"

#include <optional>

namespace sunfleck::engine {

/// Returns the reflectance along the normal; where the film's thickness is a texture, the mean over
/// the unit square of texture coordinates.
/// @return nothing for a metal whose own reflectance is a texture.
std::optional<Spectrum> film_colour(const IridescentConductorMaterial& material);

}  // namespace sunfleck::engine
