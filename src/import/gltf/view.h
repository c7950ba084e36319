// The view of a glTF scene: one of its cameras, or one that frames all of it.
#pragma once

#include "import/gltf/nodes.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Sets camera and film: of the first camera of the scene; if it has none, of one that sees all
/// shapes, of which a line tells.
void set_view(const GltfDocument& document, const GltfNodes& nodes, SceneDescription& scene);

}  // namespace sunfleck::engine
