// Selects the importer for a scene file.
#pragma once

#include "image/exposure.h"
#include "import/scene_request.h"
#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

/// Returns the format by the file's ending; pbrt's for all that are unknown.
SceneFormat format_of(const std::string& path);

/// Returns the exposure of pictures of a scene where none is asked for: automatic where light is in
/// physical units, as in all formats but pbrt's.
Exposure usual_exposure(const std::string& path);

/// Reads a scene, and adds what the user asks for besides.
/// @param path  of the scene, or "-" for standard input.
/// @throws Error  for a scene that cannot be read, and for flags without a meaning for its format.
SceneDescription load_scene(const std::string& path, const SceneRequest& request = {});

}  // namespace sunfleck::engine
