// The scene box: mirrored and glass balls in a coloured box.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Counts, sizes and materials of the Box of Table I of Hachisuka and Jensen (2011), as a scene
/// file of that number of triangles has them: 3,462, and 4 of the two lamps. Unit: as there; y up.
std::vector<SceneFile> box_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
