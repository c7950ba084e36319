// The scene cornell: the Cornell box as published, 36 triangles.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Returns one file. Unit: millimetres; y is up; the camera is outside the open front.
std::vector<SceneFile> cornell_scene();

}  // namespace sunfleck::engine
