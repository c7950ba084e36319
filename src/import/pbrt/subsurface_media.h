// Media below the surfaces of subsurface materials.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/material_table.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Fills shapes whose material, or a part of it, is subsurface scattering that is walked
/// (Assets::subsurface): what is inside them by their MediumInterface does not count (pbrt-v4).
/// @param table  whose slots are the scene's materials.
void fill_subsurface(const MaterialTable& table, Assets& assets, SceneDescription& scene);

}  // namespace sunfleck::engine
