// Loop's subdivision of triangle meshes: points and normals of the smooth limit surface.
//
// Source: Loop, Smooth Subdivision Surfaces Based on Triangles (1987); Hoppe et al., Piecewise
// Smooth Surface Reconstruction (SIGGRAPH 1994), for borders; weights near extraordinary vertices
// as pbrt-v4's.
#pragma once

#include "geometry/triangle_mesh.h"

#include <string>

namespace sunfleck::engine {

/// What keeps a mesh from being subdivided: an edge with more than two triangles, or with two that
/// run along it the same way; a triangle that names a vertex twice; a vertex where triangles meet
/// in more than one fan. Empty when nothing does.
std::string fault_of_control_mesh(const TriangleMesh& mesh);

/// The mesh after `levels` subdivisions, its vertices moved to the limit surface, with the limit's
/// normals. They point to the side from which triangles run clockwise, as pbrt-v4's do, and so
/// decide the outside. Vertices of no triangle are dropped.
/// @param control  without a fault; its normals, uvs and tangents are not used. @param levels >= 0.
TriangleMesh loop_subdivided(const TriangleMesh& control, int levels);

}  // namespace sunfleck::engine
