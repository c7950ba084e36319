// The scene fog-lamp: a lamp behind a door, and its beam through the keyhole into a room full of
// fog.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

std::vector<SceneFile> fog_lamp_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
