// Closed components of a triangle mesh, and which way their triangles face.
//
// Components are joined by edges of exactly two triangles. One is closed if all its edges have an
// even number of triangles: then it has an inside.
#pragma once

#include "math/vector.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sunfleck::engine {

struct SurfaceSides {
    std::vector<bool> is_closed;  // per triangle: part of a closed component
    /// Per triangle of a closed component: its corners should be in the other order, for normals to
    /// point outwards; of a hollow, which lies within another component, inwards.
    std::vector<bool> is_reversed;
};

/// @param triangles  by indices of vertices; those with two corners at one vertex are never closed.
/// @param positions  vertices at one place must be one.
SurfaceSides sides_of(std::span<const Vec3> positions,
                      std::span<const std::array<std::uint32_t, 3>> triangles);

/// Returns the mean length of straight ways through a closed mesh, four times its volume over its
/// area (Cauchy's theorem for convex bodies).
double mean_chord_of(std::span<const Vec3> positions,
                     std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace sunfleck::engine
