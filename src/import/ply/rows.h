// The body of a PLY file as it stands there, row by row.
#pragma once

#include "import/ply/header.h"
#include "import/ply/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// A face of more than four corners, cut into a fan of triangles.
struct PlyFan {
    std::uint64_t face = 0;  // its row
    std::size_t first = 0;   // of its triangles, which are two fewer than its corners
    std::uint64_t corners = 0;
};

/// All rows of the file, before any is checked against others.
struct PlyBody {
    PlyMesh mesh;  // without remarks
    std::vector<PlyFan> fans;
    std::vector<std::uint64_t> broken;  // vertices with a number that is no finite float, rising
    std::uint64_t faces_left_out = 0;   // of fewer than three corners
    std::uint64_t broken_uvs = 0;       // that are no finite numbers, and (0, 0) in the mesh
    bool has_face_uvs = false;          // texture coordinates of faces, which are not read
};

/// @param body  the bytes after the header. @param name  of the file, for errors.
/// @throws Error with the element and its number: cut files, counts that the file cannot hold, what
/// is no number, indices that name no vertex.
PlyBody read_rows(const PlyHeader& header, std::string_view body, const std::string& name);

}  // namespace sunfleck::engine
