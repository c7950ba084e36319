// The body of a PLY file as it stands there, and the mesh that becomes of it.
#pragma once

#include "import/pbrt/ply.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck {

/// A face of more than four corners, cut into a fan of triangles.
struct PlyFan {
    std::uint64_t face = 0;  // its row
    std::size_t first = 0;   // of its triangles, which are two fewer than its corners
    std::uint64_t corners = 0;
};

/// All rows of the file, before any is checked against others.
struct PlyBody {
    TriangleMesh mesh;          // without positions
    std::vector<Vec3d> points;  // these, as the file has them
    std::vector<PlyFan> fans;
    std::vector<std::uint64_t> broken;  // vertices with a number that is no finite float, rising
    std::uint64_t faces_left_out = 0;   // of fewer than three corners
    std::uint64_t broken_uvs = 0;       // that are no finite numbers, and (0, 0) in the mesh
    bool has_face_uvs = false;          // texture coordinates of faces, which are not read
};

/// The mesh without what no face uses. @param name  of the file, for errors.
/// @throws Error  for polygons that a fan does not cover, broken vertices that a face uses, and for
///         a body without triangles.
PlyFile finished_ply(PlyBody body, const std::string& name);

}  // namespace sunfleck
