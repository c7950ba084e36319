// Axis-aligned boxes in double.
#pragma once

#include "math/vector.h"

#include <algorithm>

namespace sunfleck::engine {

/// A box; empty until extended.
struct Bounds {
    Vec3d min = Vec3d(1e300);
    Vec3d max = Vec3d(-1e300);

    bool is_empty() const { return min.x > max.x; }
    /// The smallest box that holds this one and p.
    void extend(const Vec3d& p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }
    void extend(const Bounds& b) {
        if (b.is_empty()) return;
        extend(b.min);
        extend(b.max);
    }
    Vec3d center() const { return (min + max) * 0.5; }
    /// Of the sphere around center() through the corners.
    double radius() const { return is_empty() ? 0 : (max - min).length() * 0.5; }
};

}  // namespace sunfleck::engine
