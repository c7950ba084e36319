// Materials of pbrt-v4 that are not simulated, as others of the same energy and colour.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "material/material.h"

namespace sunfleck::engine {

/// Hair: what a fibre reflects and lets through, each spread evenly (material/fibre_albedo.h).
Material hair_stand_in(const Statement& statement, Assets& assets);
/// Skin, milk: diffuse under its surface, with the whole reflectance that it has in pbrt-v4.
Material subsurface_stand_in(const Statement& statement, Assets& assets);
/// Measured: a metal of about its roughness, or diffuse, with its mean reflectance.
Material measured_stand_in(const Statement& statement, Assets& assets);

}  // namespace sunfleck::engine
