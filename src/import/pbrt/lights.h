// Conversion of LightSource and AreaLightSource statements to lights.
#pragma once

#include "import/pbrt/parameters.h"
#include "scene/description.h"

namespace sunfleck::engine {

struct Reading;

/// Adds the light of a LightSource statement, placed by the current matrix.
/// @throws Error  for an unknown type, and for invalid parameters.
void add_light(const Statement& statement, Reading& reading);

/// Returns the emission that an AreaLightSource statement gives to the following shapes.
/// @throws Error  as add_light().
AreaEmission area_emission(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
