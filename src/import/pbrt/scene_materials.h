// Conversion of all entries of the material table at the end of all files.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/material_table.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Adds a material and a bump or normal map for each entry, in order; components of mixes become
/// further entries. Missing files are noted.
/// @throws Error  for names that a shape uses but that were never made, for cyclic mixes, and for
/// invalid parameters.
void finish_materials(MaterialTable& table, Assets& assets, SceneDescription& scene);

}  // namespace sunfleck::engine
