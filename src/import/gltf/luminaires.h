// EXT_lights_ies: lamps with measured intensities.
#pragma once

#include "import/gltf/nodes.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Adds the luminaires of the scene's nodes. The nadir of their photometry is -z of the node, and
/// horizontal angles go from x over y.
void add_luminaires(GltfDocument& document, const GltfNodes& nodes, SceneDescription& scene);

}  // namespace sunfleck::engine
