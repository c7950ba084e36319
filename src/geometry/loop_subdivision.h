// Loop's subdivision of triangle meshes: points and normals of the smooth limit surface.
//
// Source: Loop, Smooth Subdivision Surfaces Based on Triangles (1987); Hoppe et al., Piecewise
// Smooth Surface Reconstruction (SIGGRAPH 1994), for borders; weights near extraordinary vertices
// as pbrt-v4's.
#pragma once

#include "geometry/triangle_mesh.h"

#include <string>

namespace sunfleck::engine {

/// Returns why a mesh cannot be subdivided: an edge with more than two triangles, or with two in
/// the same direction; a triangle with a repeated vertex; a vertex with more than one fan of
/// triangles. Empty if it can.
std::string fault_of_control_mesh(const TriangleMesh& mesh);

/// Returns the mesh after `levels` subdivisions, with vertices moved to the limit surface and its
/// normals. As in pbrt-v4, the normals point to the side from which triangles are clockwise; they
/// select the outside. Unused vertices are dropped.
/// @param control  without a fault; its normals, uvs and tangents are ignored.
/// @param levels  not negative.
TriangleMesh loop_subdivided(const TriangleMesh& control, int levels);

}  // namespace sunfleck::engine
