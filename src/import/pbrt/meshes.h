// Meshes of a scene file: written out in the statement, or in a PLY file.
#pragma once

#include "import/pbrt/local_points.h"
#include "import/pbrt/parameters.h"

namespace sunfleck::engine {

struct Reading;

/// The numbers of a parameter by threes, in double or float; none of null.
std::vector<Vec3d> triples(const Parameter* parameter);
std::vector<Vec3> float_triples(const Parameter* parameter);

/// Shape "trianglemesh"; warns of vertices with too few digits. @throws Error for counts that do
/// not agree, and indices of no vertex.
LocalShape triangle_mesh(const Statement& statement, Reading& reading);

/// Shape "bilinearmesh". @throws Error as triangle_mesh() does.
LocalShape bilinear_mesh(const Statement& statement);

/// Shape "loopsubdiv": subdivided, on its limit surface. @throws Error as triangle_mesh() does, and
/// for meshes that have no smooth limit, or too many triangles.
LocalShape loop_mesh(const Statement& statement, Reading& reading);

/// Shape "plymesh". @throws Error as triangle_mesh() does, and for files that cannot be read.
LocalShape ply_mesh(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
