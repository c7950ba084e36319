// Lines in double, and their images under affine maps.
#pragma once

#include "geometry/affine.h"

namespace sunfleck::engine {

/// A line origin + t * direction.
struct Line {
    Vec3d origin;
    Vec3d direction;

    Line through(const Affine& map) const { return {map.point(origin), map.vector(direction)}; }
    /// The same line, counted from a later point.
    Line from(double t) const { return {origin + direction * t, direction}; }
};

}  // namespace sunfleck::engine
