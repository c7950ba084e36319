// Normals by smoothing groups, for corners that the file gives none.
#pragma once

#include "import/obj/mesh.h"

namespace sunfleck::engine {

/// Adds normals to all triangles in a smoothing group that have none: at each vertex the mean of
/// the faces of that group, weighted by their angles there. Triangles that are in no group stay
/// flat.
void smooth(ObjMesh& mesh);

}  // namespace sunfleck::engine
