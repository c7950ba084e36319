// Triangle meshes of a scene file: written out in the statement, or in a PLY file.
#pragma once

#include "geometry/triangle_mesh.h"
#include "import/pbrt/parameters.h"

namespace sunfleck {

struct Reading;

/// Shape "trianglemesh". @throws Error for counts that do not agree, and indices of no vertex.
TriangleMesh triangle_mesh(const Statement& statement);

/// Shape "plymesh". @throws Error as triangle_mesh() does, and for files that cannot be read.
TriangleMesh ply_mesh(const Statement& statement, Reading& reading);

}  // namespace sunfleck
