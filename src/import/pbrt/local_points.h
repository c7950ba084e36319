// Vertices in double, as in the file, converted to floats relative to a nearby origin.
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

/// Points relative to a nearby origin, for which floats keep all detail.
struct LocalPoints {
    std::vector<Vec3> points;
    Vec3d origin{0};
};

/// Returns the points minus their origin_near().
/// @param used  indices of the points that count; invalid indices are ignored.
LocalPoints local_points(const std::vector<Vec3d>& points, std::span<const std::uint32_t> used);

/// Returns the corners of all faces as one list.
template <std::size_t N>
std::span<const std::uint32_t> all_corners(const std::vector<std::array<std::uint32_t, N>>& faces) {
    return {faces.empty() ? nullptr : faces.front().data(), N * faces.size()};
}

/// Returns what is wrong with points far from the origin that were rounded to floats with a spacing
/// above an eighth of the mean edge length. Empty if nothing is.
std::string coarseness_of(const LocalPoints& local,
                          const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace sunfleck::engine
