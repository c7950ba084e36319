// The lights that a user asks for besides those of the scene file.
#pragma once

#include "import/scene_request.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Adds daylight and an environment where they are asked for, and daylight also to a scene without
/// light whose format is not pbrt's; a warning tells it.
/// @param up  of the scene's world.
/// @throws Error  for what cannot be used.
void add_asked_lights(SceneDescription& scene, const SceneRequest& request, SceneFormat format,
                      UpAxis up);

}  // namespace sunfleck::engine
