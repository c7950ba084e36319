// The scene opal: a lantern whose front is a pane of opal glass, the only light of some things on a
// table.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

std::vector<SceneFile> opal_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
