// The glow of media as lights.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine {

/// Adds a light to a scene for each medium that emits. @param scene  in rendering space.
void add_medium_lights(SceneDescription& scene);

}  // namespace sunfleck::engine
