// Reader of STL files: triangles alone, binary or ASCII.
//
// Source: 3D Systems, StereoLithography Interface Specification (1988).
#pragma once

#include "math/vector.h"
#include "sunfleck/error.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// The triangles of an STL file, all solids together. Vertices at one place are one vertex, so that
/// closed surfaces are closed.
struct StlMesh {
    std::vector<Vec3> positions;  // finite
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::string> remarks;  // what was left out
};

/// Reads an STL file. A binary one is told by its size, 84 bytes and 50 for each triangle, whatever
/// word it begins with. Normals are left out: the order of the corners says the same. Triangles of
/// which two corners are at one place, and colours, are left out with a remark.
/// @param name  file name for errors.
/// @throws Error  with line and column, or the triangle (from 0), for truncated files, corners that
/// are not finite, statements that are none, and a file without triangles.
StlMesh parse_stl(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
