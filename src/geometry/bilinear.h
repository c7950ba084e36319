// A bilinear patch: the surface that four points span, ruled by straight lines both ways.
//
// P(u, v) = (1 - u)(1 - v) p00 + u (1 - v) p10 + (1 - u) v p01 + u v p11, u and v in [0, 1].
// All in double, in one frame.
#pragma once

#include "geometry/local_surface.h"

namespace sunfleck::engine {

/// What four values at the corners give at (u, v). Order of corners: 00, 10, 01, 11.
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
    /// dP/du x dP/dv: linear in u and in v, its length the area per unit of du dv.
    Vec3d area_vector(const Vec2d& uv) const { return du(uv.y).cross(dv(uv.x)); }
    std::array<Vec3d, 4> area_vectors_at_corners() const {
        return {area_vector({0, 0}), area_vector({1, 0}), area_vector({0, 1}), area_vector({1, 1})};
    }

    /// Where a line meets it; `uv` of each crossing that is on.
    struct Meetings {
        Crossings line;
        std::array<Vec2d, 2> uv;
    };
    /// Source for the quadratic equation: Reshetov, Cool Patches: A Geometric Approach to
    /// Ray/Bilinear Patch Intersections (Ray Tracing Gems, 2019).
    Meetings meet(const Vec3d& origin, const Vec3d& direction) const;
    /// The (u, v) of the point of the patch nearest to `on`, a rounding error off, along a
    /// direction that leaves the patch.
    Vec2d locate(const Vec3d& on, const Vec3d& direction) const;
    /// In the frame of the corners; relative error below 1e-6. By quadrature if it is not flat.
    double area() const;
    Bilinear image(const Affine& map) const;
    Bounds bounds() const;
};

}  // namespace sunfleck::engine
