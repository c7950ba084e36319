// The extent of surfaces that ray tracing allows.
#pragma once

#include "geometry/bounds.h"
#include "geometry/geometry_input.h"
#include "geometry/triangle.h"

#include <cstddef>

namespace sunfleck::engine {

/// The sum of a surface's or ray's coordinates; larger ones may abort the program inside Embree.
inline constexpr double kLargestExtent = 1e18;

/// Returns whether Geometry can have the triangle; false if a coordinate is not finite.
inline bool is_in_range(const Triangle& triangle) {
    double size = 0;
    for (const Vec3d& p : triangle.corner) size += absolute_dot(p, Vec3d(1));
    return size < kLargestExtent;
}

/// Returns whether Geometry can have a surface with such a box.
inline bool is_in_range(const Bounds& box) {
    return absolute_dot(box.min, Vec3d(1)) + absolute_dot(box.max, Vec3d(1)) < kLargestExtent;
}

/// Counts the triangles, patches, curves or quadrics that Geometry leaves out for their extent.
std::size_t count_out_of_range(const PlacedShape& placed);

}  // namespace sunfleck::engine
