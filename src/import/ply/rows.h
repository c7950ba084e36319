// Reads the body of a PLY file row by row.
#pragma once

#include "import/ply/header.h"
#include "import/ply/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// A face of more than four corners as a fan of triangles.
struct PlyFan {
    std::uint64_t face = 0;  // its row
    std::size_t first = 0;   // index of its first triangle; it has two triangles fewer than corners
    std::uint64_t corners = 0;
};

/// All rows of the file, before they are checked against each other.
struct PlyBody {
    PlyMesh mesh;  // without remarks
    std::vector<PlyFan> fans;
    std::vector<std::uint64_t>
        broken;  // vertices with a number that is not a finite float, ascending
    std::uint64_t faces_left_out = 0;  // faces of fewer than three corners
    std::uint64_t broken_uvs = 0;      // not finite, (0, 0) in the mesh
    bool has_face_uvs = false;         // texture coordinates of faces, which are not read
};

/// Reads all rows.
/// @param body  the bytes after the header.
/// @param name  file name for errors.
/// @throws Error  with the element and its index, for truncated files, counts that the file cannot
/// hold, invalid numbers, and invalid vertex indices.
PlyBody read_rows(const PlyHeader& header, std::string_view body, const std::string& name);

}  // namespace sunfleck::engine
