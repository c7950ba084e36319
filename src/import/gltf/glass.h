// Solid and thin glass: which parts of a mesh are closed.
//
// Exporters write solid glass without a volume, which glTF calls thin-walled. A component whose
// every edge two triangles share has an inside, so its glass is solid; any other is a pane.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Returns, of each triangle, whether it is part of a closed component. Vertices at one place are
/// one vertex.
/// @param meshes  all primitives of a mesh together, because they may close each other.
std::vector<std::vector<bool>> closed_triangles(const std::vector<const TriangleMesh*>& meshes);

/// Returns the mean length of straight ways through a closed mesh, four times its volume over its
/// area (Cauchy's theorem for convex bodies).
double mean_chord(const TriangleMesh& mesh);

/// Returns the absorption by which so much of each colour is left after a distance (Beer's law).
/// @param distance  positive. @param left  at least a millionth counts.
Vec3d absorption_over(double distance, const Vec3d& left);

/// Returns the triangles that are chosen, with all vertices.
TriangleMesh chosen_triangles(const TriangleMesh& mesh, const std::vector<bool>& chosen);

}  // namespace sunfleck::engine
