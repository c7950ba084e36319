// The scene iced-tea: a tumbler of tea with ice under a clear sky, and its light on the table.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// The scene's file, five meshes and the sky. Centimetres, z up.
std::vector<SceneFile> iced_tea_scene();

}  // namespace sunfleck::engine
