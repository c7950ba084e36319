// Polygons of more than four corners: whether a fan of triangles covers them.
#pragma once

#include "math/vector.h"

#include <span>

namespace sunfleck::engine {

/// Returns whether a fan from the first corner covers the polygon once: it is planar and convex
/// within 10^-4 of its size, and within the precision of six decimal digits.
bool is_planar_and_convex(std::span<const Vec3d> corners);

}  // namespace sunfleck::engine
