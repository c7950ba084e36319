// The scene pool: under murky water, the sun's shafts below the waves and their light on the tiles.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

std::vector<SceneFile> pool_scene(const ProceduralScene& scene);

/// Returns the body of water as a closed mesh with normals outwards: waves on top; sides and bottom
/// lie within the walls of the pool.
Mesh pool_water();

}  // namespace sunfleck::engine
