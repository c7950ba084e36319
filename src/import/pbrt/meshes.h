// Conversion of meshes: given in the statement, or in a PLY file.
#pragma once

#include "import/pbrt/local_points.h"
#include "import/pbrt/parameters.h"

namespace sunfleck::engine {

struct Reading;

/// Returns the numbers of a parameter in triples, in double or float; none for null.
std::vector<Vec3d> triples(const Parameter* parameter);
std::vector<Vec3> float_triples(const Parameter* parameter);

/// Converts Shape "trianglemesh"; warns of vertices with too few digits.
/// @throws Error  for counts that do not agree, and for invalid vertex indices.
LocalShape triangle_mesh(const Statement& statement, Reading& reading);

/// Converts Shape "bilinearmesh". @throws Error  as triangle_mesh().
LocalShape bilinear_mesh(const Statement& statement);

/// Converts Shape "loopsubdiv" to its limit surface.
/// @throws Error  as triangle_mesh(), and for meshes without smooth limit or with too many
/// triangles.
LocalShape loop_mesh(const Statement& statement, Reading& reading);

/// Converts Shape "plymesh". @throws Error  as triangle_mesh(), and for files that cannot be read.
LocalShape ply_mesh(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
