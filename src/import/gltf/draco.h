// KHR_draco_mesh_compression: vertices and triangles that Google's Draco has packed.
//
// Built in where CMake finds Draco (SUNFLECK_DRACO).
#pragma once

#include "import/gltf/accessors.h"

namespace sunfleck::engine {

/// Returns whether this program can unpack them.
bool has_draco();

/// Unpacks the primitives of all meshes, so that their accessors have elements. Without Draco it
/// does nothing.
/// @throws Error  for damaged data, and for data that do not fit their accessors.
void unpack_draco(const GltfDocument& document, Accessors& accessors);

}  // namespace sunfleck::engine
