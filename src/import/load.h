// Chooses the importer for a scene file.
#pragma once

#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

/// @param path  of the scene, or "-" for standard input. @throws Error for what cannot be read.
SceneDescription load_scene(const std::string& path);

}  // namespace sunfleck::engine
