// KHR_lights_punctual: points, spots and directional lights.
#pragma once

#include "import/gltf/nodes.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Adds the lights of the scene's nodes.
void add_punctual_lights(const GltfDocument& document, const GltfNodes& nodes,
                         SceneDescription& scene);

}  // namespace sunfleck::engine
