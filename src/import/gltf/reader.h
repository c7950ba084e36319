// Reader of glTF 2.0 scenes (.gltf, .glb); docs/reference/gltf.md lists what is read and what is
// approximated.
#pragma once

#include "import/gltf/document.h"
#include "scene/description.h"
#include "scene/import_settings.h"

#include <string>

namespace sunfleck::engine {

/// Reads a scene. SceneDescription::warnings lists what is not simulated as asked.
/// @throws Error  for what is not glTF 2.0, is damaged, or requires an extension that is not read.
SceneDescription read_gltf(const std::string& path, const ImportSettings& settings = {});

/// Reads a scene whose document is in memory.
SceneDescription read_gltf_document(GltfDocument& document, const ImportSettings& settings = {});

}  // namespace sunfleck::engine
