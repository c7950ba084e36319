// Triangles that share vertices.
#pragma once

#include "math/vector.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// The geometric normal of a triangle is (p1 - p0) x (p2 - p0); with vertex normals it is turned
/// to agree with the interpolated one (pbrt-v4).
struct TriangleMesh {
    std::vector<Vec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Vec3> normals;   // one a vertex, or empty
    std::vector<Vec2> uvs;       // one a vertex, or empty
    std::vector<Vec3> tangents;  // one a vertex, or empty
};

}  // namespace sunfleck::engine
