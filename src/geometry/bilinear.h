// Bilinear patch: the doubly ruled surface that four points span.
//
// P(u, v) = (1 - u)(1 - v) p00 + u (1 - v) p10 + (1 - u) v p01 + u v p11, u and v in [0, 1]. All
// points are doubles in one frame.
#pragma once

#include "geometry/local_surface.h"

namespace sunfleck::engine {

/// Interpolates four corner values at (u, v). Order of corners: 00, 10, 01, 11.
template <class V>
V bilinear(const std::array<V, 4>& at_corner, const Vec2d& uv) {
    using Number = typename V::BaseType;
    const auto weight = [](double w) { return static_cast<Number>(w); };
    return at_corner[0] * weight((1 - uv.x) * (1 - uv.y)) +
           at_corner[1] * weight(uv.x * (1 - uv.y)) + at_corner[2] * weight((1 - uv.x) * uv.y) +
           at_corner[3] * weight(uv.x * uv.y);
}

struct Bilinear {
    std::array<Vec3d, 4> corner;  // 00, 10, 01, 11

    Vec3d point(const Vec2d& uv) const { return bilinear(corner, uv); }
    Vec3d du(double v) const {
        return (corner[1] - corner[0]) * (1 - v) + (corner[3] - corner[2]) * v;
    }
    Vec3d dv(double u) const {
        return (corner[2] - corner[0]) * (1 - u) + (corner[3] - corner[1]) * u;
    }
    /// Returns dP/du x dP/dv, which is linear in u and in v; its length is the area per unit of du
    /// dv.
    Vec3d area_vector(const Vec2d& uv) const { return du(uv.y).cross(dv(uv.x)); }
    std::array<Vec3d, 4> area_vectors_at_corners() const {
        return {area_vector({0, 0}), area_vector({1, 0}), area_vector({0, 1}), area_vector({1, 1})};
    }

    /// Intersections of a line with the patch; `uv` of each one on the patch.
    struct Hits {
        Crossings line;
        std::array<Vec2d, 2> uv;
    };
    /// Intersects a line with the patch.
    /// Source for the quadratic equation: Reshetov, Cool Patches: A Geometric Approach to
    /// Ray/Bilinear Patch Intersections (Ray Tracing Gems, 2019).
    Hits intersect(const Vec3d& origin, const Vec3d& direction) const;
    /// Returns (u, v) of the patch point nearest to `on`, which is a rounding error away along a
    /// direction that is not tangent to the patch.
    Vec2d locate(const Vec3d& on, const Vec3d& direction) const;
    /// Returns the area in the corners' frame, with a relative error below 1e-6 (by quadrature if
    /// not planar).
    double area() const;
    Bilinear image(const Affine& map) const;
    Bounds bounds() const;
};

}  // namespace sunfleck::engine
