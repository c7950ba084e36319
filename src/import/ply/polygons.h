// Faces of more than four corners: which of them a fan of triangles covers.
#pragma once

#include "math/vector.h"

#include <span>

namespace sunfleck::engine {

/// True if a fan from the first corner covers the polygon once: it is planar and convex within
/// 10^-4 of its size, and within what six digits of its coordinates tell.
bool is_planar_and_convex(std::span<const Vec3d> corners);

}  // namespace sunfleck::engine
