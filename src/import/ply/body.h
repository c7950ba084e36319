// The mesh that becomes of the rows of a PLY file: checks and repairs that need all of them.
#pragma once

#include "import/ply/rows.h"

#include <string>

namespace sunfleck::engine {

/// The mesh without what no face uses. @param name  of the file, for errors.
/// @throws Error  for polygons that a fan does not cover, broken vertices that a face uses, and for
///         a body without triangles.
PlyMesh finished_ply(PlyBody body, const std::string& name);

}  // namespace sunfleck::engine
