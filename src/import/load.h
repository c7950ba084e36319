// Selects the importer for a scene file.
#pragma once

#include "scene/description.h"
#include "scene/import_settings.h"

#include <string>

namespace sunfleck::engine {

/// Reads a scene.
/// @param path  of the scene, or "-" for standard input.
/// @param settings  what its format leaves open; pbrt-v4 leaves nothing open.
/// @throws Error  for a scene that cannot be read.
SceneDescription load_scene(const std::string& path, const ImportSettings& settings = {});

}  // namespace sunfleck::engine
