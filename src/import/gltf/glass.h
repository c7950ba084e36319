// Solid and thin glass: which parts of a mesh are closed.
//
// Exporters write solid glass without a volume, which glTF calls thin-walled. A component whose
// every edge two triangles share has an inside, so its glass is solid; any other is a pane.
#pragma once

#include "geometry/closed_surface.h"
#include "geometry/triangle_mesh.h"

#include <vector>

namespace sunfleck::engine {

/// Returns which triangles of each mesh are parts of closed components, and which of them face the
/// wrong way. Vertices at one place are one vertex.
/// @param meshes  all primitives of a mesh together, because they may close each other.
std::vector<SurfaceSides> sides_of_primitives(const std::vector<const TriangleMesh*>& meshes);

/// Turns triangles, with the normals of their vertices. @param reversed  per triangle.
void turn_triangles(TriangleMesh& mesh, const std::vector<bool>& reversed);

/// Returns the triangles that are chosen, with all vertices.
TriangleMesh chosen_triangles(const TriangleMesh& mesh, const std::vector<bool>& chosen);

}  // namespace sunfleck::engine
