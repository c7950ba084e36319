// The triangles of a PLY file.
#pragma once

#include "math/vector.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct PlyMesh {
    std::vector<Vec3d> positions;  // as the file has them, within the range of floats
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Vec3> normals;         // one a vertex, or empty; may be no numbers
    std::vector<Vec2> uvs;             // one a vertex, or empty; finite
    std::vector<std::string> remarks;  // what of the file the mesh has not
};

}  // namespace sunfleck::engine
