// The view of a glTF scene: one of its cameras, or one that frames all of it.
#pragma once

#include "import/gltf/nodes.h"
#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

/// Sets camera and film: of the chosen camera of the scene; if it has none, of one that sees all
/// shapes, of which a line tells.
/// @param chosen  name of the camera or of its node, or its number from 1; empty for the first.
/// @throws Error  for a camera that the scene lacks.
void set_view(const GltfDocument& document, const GltfNodes& nodes, const std::string& chosen,
              SceneDescription& scene);

}  // namespace sunfleck::engine
