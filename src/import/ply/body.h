// Completes a PLY mesh: checks and repairs that need all rows.
#pragma once

#include "import/ply/rows.h"

#include <string>

namespace sunfleck::engine {

/// Returns the mesh without unused vertices.
/// @param name  file name for errors.
/// @throws Error  for polygons that a fan does not cover, for broken vertices that a face uses, and
/// for a body without triangles.
PlyMesh finished_ply(PlyBody body, const std::string& name);

}  // namespace sunfleck::engine
