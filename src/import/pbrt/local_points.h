// Vertices in double, as a file gives them, and in float, relative to an origin near them.
#pragma once

#include "geometry/middle.h"
#include "geometry/shape.h"

#include <span>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A shape in a frame of its own.
struct LocalShape {
    Shape shape;
    Vec3d origin{0};  // of that frame, in the frame of the shape's statement
};

/// Points relative to an origin near them: floats keep their detail wherever they stand.
struct LocalPoints {
    std::vector<Vec3> points;
    Vec3d origin{0};
};

/// The points less origin_near() them.
/// @param used  indices of those that say where the points are; an index of no point is passed
/// over.
LocalPoints local_points(const std::vector<Vec3d>& points, std::span<const std::uint32_t> used);

/// Corners of faces, one after the other.
template <std::size_t N>
std::span<const std::uint32_t> all_corners(const std::vector<std::array<std::uint32_t, N>>& faces) {
    return {faces.empty() ? nullptr : faces.front().data(), N * faces.size()};
}

/// What is wrong with points far from the origin that were rounded to floats, whose steps there are
/// more than an eighth of the mean length of an edge. Empty if nothing is.
std::string coarseness_of(const LocalPoints& local,
                          const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace sunfleck::engine
