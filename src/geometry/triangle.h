// One triangle in double: where a line meets it, and how far Embree's arithmetic may miss it.
#pragma once

#include "math/vector.h"

#include <array>

namespace sunfleck {

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

/// Barycentric weights (of corners 0, 1, 2; their sum is one) of the point where a line meets the
/// plane of a triangle that Embree says is hit. Embree takes a triangle 10 km wide for hit up to a
/// millimetre outside; the point on the line is then nearer to the truth (which is the neighbour)
/// than the nearest point of the triangle, so weights down to -2^-10 are left as they are. A line
/// that is farther off (it grazes the plane) gives the nearest point of the border.
/// @param fallback  the weights of corners 1 and 2, for a line within the plane.
/// Source: Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997).
Vec3d barycentrics(const Triangle& triangle, const Vec3d& origin, const Vec3d& direction,
                   const Vec2d& fallback);

/// How far from the plane of the triangle a ray must start, at least, for Embree to know which
/// side of the plane it starts on, when it starts near `position` on the triangle.
/// @param area_vector  of the triangle; not zero. @param position  a point of the triangle.
double plane_uncertainty(const Triangle& triangle, const Vec3d& area_vector, const Vec3d& position);

/// Half a unit in the last place of a float is at most this, relative to the float.
inline constexpr double kFloatRounding = 0x1p-24;

/// The part along `normal` of the errors of rounding `position` to float twice: when it is stored,
/// and when the offset is added to it. With a margin.
double rounding_uncertainty(const Vec3d& normal, const Vec3d& position);

/// The sum of |a_i| |b_i|.
inline double absolute_dot(const Vec3d& a, const Vec3d& b) {
    return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}

}  // namespace sunfleck
