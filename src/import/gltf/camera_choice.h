// Which of the cameras of a glTF scene the user asks for.
#pragma once

#include "import/gltf/nodes.h"

#include <optional>
#include <string>

namespace sunfleck::engine {

/// Returns the node of a camera; nothing where the scene has no camera and none is asked for.
/// @param chosen  name of the camera or of its node, or its number from 1; empty for the first.
/// @throws Error  for a camera that the scene lacks.
std::optional<GltfNode> chosen_camera(const GltfDocument& document, const GltfNodes& nodes,
                                      const std::string& chosen);

}  // namespace sunfleck::engine
