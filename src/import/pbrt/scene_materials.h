// The materials of a scene, made of the table's slots when all files have ended.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/material_table.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Adds a material and a relief for each slot, in the order of the slots. Parts of mixes become
/// further slots. Missing files are noted with the other missing ones.
/// @throws Error for names that were never made, though a shape uses them, for mixes that mix each
/// other in a circle, and for parameters that cannot be used.
void finish_materials(MaterialTable& table, Assets& assets, SceneDescription& scene);

}  // namespace sunfleck::engine
