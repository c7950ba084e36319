// pbrt-v4's subsurface scattering: as a coat over a diffuse surface, or as what it is, a medium
// below a dielectric.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "material/material.h"
#include "scene/media.h"

namespace sunfleck::engine {

/// Approximates subsurface scattering by a coated diffuse material with pbrt-v4's total albedo;
/// where it is walked (Assets::subsurface), returns the dielectric at the surface.
Material subsurface_material(const Statement& statement, Assets& assets);

/// Returns the medium below. A "reflectance" becomes the albedo of single scattering that has it
/// as its total albedo (pbrt-v4).
Medium medium_below(const Statement& statement, Assets& assets);

}  // namespace sunfleck::engine
