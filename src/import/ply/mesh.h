// PlyMesh: the triangles of a PLY file.
#pragma once

#include "math/vector.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct PlyMesh {
    std::vector<Vec3d> positions;  // as in the file, within the range of floats
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Vec3> normals;         // one per vertex, or empty; may be NaN
    std::vector<Vec2> uvs;             // one per vertex, or empty; finite
    std::vector<Vec3> colours;         // one per vertex, or empty; in [0,1], as stored
    std::vector<std::string> remarks;  // what was left out or changed
};

}  // namespace sunfleck::engine
