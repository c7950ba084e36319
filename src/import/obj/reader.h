// Reader of OBJ files: polygons with texture coordinates, normals, materials and smoothing groups.
//
// Source: Wavefront, Object Files, appendix B1 of the Advanced Visualizer's manual (version 3.0).
#pragma once

#include "import/obj/mesh.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Reads v with colours, vt, vn, f, s, usemtl and mtllib; indices may be negative, or name what
/// comes later in the file. Polygons become triangles: convex ones a fan, concave ones by cutting
/// off ears. Each of the following gives a remark: weights of vertices, points, lines, curves and
/// surfaces, and unknown statements are left out; faces of fewer than three corners and triangles
/// with two corners at one vertex are left out; normals that are none leave their triangles flat;
/// texture coordinates that are not finite become (0, 0).
/// @param name  file name for errors.
/// @throws Error  with line and column for statements that cannot be read, indices of what the file
/// does not have, and vertices of faces that are not finite; for files without faces.
ObjMesh parse_obj(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
