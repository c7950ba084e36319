// Selects the importer for a scene file.
#pragma once

#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

/// Reads a scene.
/// @param path  of the scene, or "-" for standard input.
/// @throws Error  for a scene that cannot be read.
SceneDescription load_scene(const std::string& path);

}  // namespace sunfleck::engine
