// One triangle in double: where a line meets it, and how far Embree's arithmetic may miss it.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {

struct Triangle {
    std::array<Vec3d, 3> corner;

    /// Twice the area, along the side from which the corners run counter-clockwise.
    Vec3d area_vector() const { return (corner[1] - corner[0]).cross(corner[2] - corner[0]); }
    double area() const { return 0.5 * area_vector().length(); }
    /// False when the area is no more than the rounding errors of these doubles.
    bool has_area() const {
        const Vec3d a = corner[1] - corner[0];
        const Vec3d b = corner[2] - corner[0];
        return a.cross(b).length2() > 0x1p-100 * a.length2() * b.length2();
    }
    Vec3d point(const Vec3d& weights) const {
        return corner[0] * weights.x + corner[1] * weights.y + corner[2] * weights.z;
    }
};

/// The sum of |a_i| |b_i|.
inline double absolute_dot(const Vec3d& a, const Vec3d& b) {
    return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}

/// The two edges from corner 0: all that is asked about a hit starts from them.
struct TriangleEdges {
    Vec3d first;   // to corner 1
    Vec3d second;  // to corner 2

    explicit TriangleEdges(const Triangle& t)
        : first(t.corner[1] - t.corner[0]), second(t.corner[2] - t.corner[0]) {}
    Vec3d area_vector() const { return first.cross(second); }
};

/// The weights of the point of the border that is nearest to the point with these weights.
Vec3d weights_on_border(const Triangle& triangle, const Vec3d& weights);

/// Barycentric weights (of corners 0, 1, 2; their sum is one) of the point where a line meets the
/// plane of a triangle that Embree says is hit. Embree takes a triangle 10 km wide for hit up to a
/// millimetre outside; the point on the line is then nearer to the truth (which is the neighbour)
/// than the nearest point of the triangle, so weights down to -2^-10 are left as they are. A line
/// that is farther off (it grazes the plane) gives the nearest point of the border.
/// @param fallback  the weights of corners 1 and 2, for a line within the plane.
/// Source: Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997).
inline Vec3d barycentrics(const Triangle& triangle, const TriangleEdges& edges, const Vec3d& origin,
                          const Vec3d& direction, const Vec2d& fallback) {
    const Vec3d across = direction.cross(edges.second);
    const double inverse = 1 / edges.first.dot(across);
    const Vec3d to_origin = origin - triangle.corner[0];
    double u = to_origin.dot(across) * inverse;
    double v = direction.dot(to_origin.cross(edges.first)) * inverse;
    if (!std::isfinite(u + v)) {
        u = fallback.x;
        v = fallback.y;
    }
    const Vec3d weights(1 - u - v, u, v);
    constexpr double kOutside = -0x1p-10;
    if (u >= kOutside && v >= kOutside && weights.x >= kOutside) return weights;
    return weights_on_border(triangle, weights);
}
inline Vec3d barycentrics(const Triangle& triangle, const Vec3d& origin, const Vec3d& direction,
                          const Vec2d& fallback) {
    return barycentrics(triangle, TriangleEdges(triangle), origin, direction, fallback);
}

/// The bound of plane_uncertainty() in roundings, times the length of the area vector.
/// Embree's robust test takes the sign of t from that of v0 . Ng, in float, where v_k is corner k
/// minus the ray's origin, the edges are e0 = v2 - v0, e1 = v0 - v1, e2 = v1 - v2, and each
/// component of Ng comes from e0 x e1 or e1 x e2, whichever rounds the smaller product. With r one
/// rounding and w the largest |v_k| of each axis, the error of v0 . Ng / |Ng| is at most the sum of
///  - r w . |n|: the rounding of v0 itself;
///  - 8 r w . |n|: an edge is off by de <= 4 r w, and the triple product (de, e, v0) is de . n
///    times |e x v0|, which is no more than |Ng|, for both lie in the triangle's plane;
///  - 4 r w . |n|: the rounding of Ng, and of the sum over the axes;
///  - r |v0| . m / |Ng|: the rounding of the smaller products m. It is large for caps (a corner
///    near the opposite edge), and there Embree is really that uncertain.
/// Rays that leave within about 2^-22 of the plane itself are not covered: there the sign of the
/// denominator is uncertain, too.
inline double scaled_plane_uncertainty(const Triangle& triangle, const TriangleEdges& edges,
                                       const Vec3d& area_vector, const Vec3d& position) {
    const Vec3d v0 = triangle.corner[0] - position;
    const Vec3d v1 = triangle.corner[1] - position;
    const Vec3d v2 = triangle.corner[2] - position;
    const auto reach = [](double a, double b, double c) {
        return std::max(std::max(std::abs(a), std::abs(b)), std::abs(c));
    };
    const Vec3d w(reach(v0.x, v1.x, v2.x), reach(v0.y, v1.y, v2.y), reach(v0.z, v1.z, v2.z));
    // e0 is the second edge, -e1 the first; of a x b the products a_j b_k that are rounded.
    const Vec3d& e0 = edges.second;
    const Vec3d& e1 = edges.first;
    const Vec3d e2 = edges.first - edges.second;
    const auto smaller = [](double a, double b) { return std::min(std::abs(a), std::abs(b)); };
    const Vec3d products(smaller(e0.z * e1.y, e1.z * e2.y), smaller(e0.x * e1.z, e1.x * e2.z),
                         smaller(e0.y * e1.x, e1.y * e2.x));
    return 13 * absolute_dot(area_vector, w) + 2 * absolute_dot(v0, products);
}

/// Half a unit in the last place of a float is at most this, relative to the float.
inline constexpr double kFloatRounding = 0x1p-24;

/// How far from the plane of the triangle a ray must start, at least, for Embree to know which
/// side of the plane it starts on, when it starts near `position` on the triangle.
/// @param area_vector  of the triangle; not zero. @param position  a point of the triangle.
double plane_uncertainty(const Triangle& triangle, const Vec3d& area_vector, const Vec3d& position);

/// rounding_uncertainty(), in roundings.
inline constexpr double kStoringRoundings = 2.1;

/// The part along `normal` of the errors of rounding `position` to float twice: when it is stored,
/// and when the offset is added to it. With a margin.
inline double rounding_uncertainty(const Vec3d& normal, const Vec3d& position) {
    return kStoringRoundings * kFloatRounding * absolute_dot(normal, position);
}

}  // namespace sunfleck::engine
