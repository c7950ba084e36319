// The scene iced-tea: a tumbler of tea with ice under a clear sky, with its caustics on the table.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Returns the scene file, five meshes and the sky. Unit: centimetres; z is up.
std::vector<SceneFile> iced_tea_scene();

}  // namespace sunfleck::engine
