// The scene cornell: the Cornell box as published, 36 triangles.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// One file. Millimetres, y up, camera outside the open front.
std::vector<SceneFile> cornell_scene();

}  // namespace sunfleck::engine
