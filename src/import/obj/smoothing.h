// Normals of a mesh: those that are none, and those of smoothing groups.
#pragma once

#include "import/obj/mesh.h"

namespace sunfleck::engine {

/// Leaves triangles flat of which a normal is zero or not finite. @return their number.
std::size_t drop_broken_normals(ObjMesh& mesh);

/// Adds normals to all triangles in a smoothing group that have none: at each vertex the mean of
/// the faces of that group, weighted by their angles there. Triangles that are in no group stay
/// flat.
void smooth(ObjMesh& mesh);

}  // namespace sunfleck::engine
