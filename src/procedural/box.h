// The scene box: mirrored and glass balls in a coloured box.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Returns the Box of Table I of Hachisuka and Jensen (2011) with its counts, sizes and materials:
/// 3,462 triangles as in the paper, and 4 of the two lamps. Unit: as in the paper; y is up.
std::vector<SceneFile> box_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
