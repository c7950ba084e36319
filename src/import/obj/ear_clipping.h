// Triangulation of polygons with three and more corners, concave ones, too.
#pragma once

#include "math/vector.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sunfleck::engine {

/// Triangles of a polygon, by indices of its corners.
struct Triangulation {
    std::vector<std::array<std::uint32_t, 3>> triangles;  // two fewer than corners
    bool is_simple = true;  // false: the outline crosses itself, or has no area
};

/// Returns whether a quad is seen as convex along its mean normal.
bool is_convex_quad(const std::array<Vec3d, 4>& corners);

/// Cuts off ears one by one, seen along the mean normal. A convex quad becomes 0 1 2 and 0 2 3.
/// It takes a time of corners times concave corners. @param corners  at least 3, finite.
Triangulation triangulated(std::span<const Vec3d> corners);

}  // namespace sunfleck::engine
