// Meshes of a scene file: written out in the statement, or in a PLY file.
#pragma once

#include "geometry/bilinear_mesh.h"
#include "geometry/triangle_mesh.h"
#include "import/pbrt/parameters.h"

namespace sunfleck {

struct Reading;

/// The numbers of a parameter by threes; none of null.
std::vector<Vec3> triples(const Parameter* parameter);

/// Shape "trianglemesh". @throws Error for counts that do not agree, and indices of no vertex.
TriangleMesh triangle_mesh(const Statement& statement);

/// Shape "bilinearmesh". @throws Error as triangle_mesh() does.
BilinearMesh bilinear_mesh(const Statement& statement);

/// Shape "loopsubdiv": subdivided, on its limit surface. @throws Error as triangle_mesh() does, and
/// for meshes that have no smooth limit, or too many triangles.
TriangleMesh loop_mesh(const Statement& statement);

/// Shape "plymesh". @throws Error as triangle_mesh() does, and for files that cannot be read.
TriangleMesh ply_mesh(const Statement& statement, Reading& reading);

}  // namespace sunfleck
