// Affine maps in double, ready for the inner loop: points, directions and normals.
//
// In:  the object-to-world matrix of a placed shape or instance (row vectors, as Imath has it).
// Out: images under it and under its inverse. Only + - * / on doubles: the same bits everywhere.
#pragma once

#include "math/vector.h"

#include <cmath>

namespace sunfleck::engine {

/// p -> p.x * x + p.y * y + p.z * z + origin.
struct Affine {
    Vec3d x{1, 0, 0};  // images of the unit vectors
    Vec3d y{0, 1, 0};
    Vec3d z{0, 0, 1};
    Vec3d origin{0, 0, 0};  // image of the origin

    Affine() = default;
    /// The last column is taken to be (0 0 0 1).
    explicit Affine(const Matrix& m)
        : x(m[0][0], m[0][1], m[0][2]),
          y(m[1][0], m[1][1], m[1][2]),
          z(m[2][0], m[2][1], m[2][2]),
          origin(m[3][0], m[3][1], m[3][2]) {}

    Vec3d vector(const Vec3d& v) const { return x * v.x + y * v.y + z * v.z; }
    Vec3d point(const Vec3d& p) const { return vector(p) + origin; }
    double determinant() const { return x.dot(y.cross(z)); }

    /// Finite, and its determinant more than the rounding errors of its terms.
    bool is_invertible() const {
        const double volume = std::abs(determinant());
        const bool finite = std::isfinite(volume) && std::isfinite(origin.x + origin.y + origin.z);
        return finite && volume > 1e-14 * x.length() * y.length() * z.length();
    }

    /// Of an invertible map.
    Affine inverse() const {
        const double scale = 1 / determinant();
        const Vec3d a = y.cross(z) * scale;
        const Vec3d b = z.cross(x) * scale;
        const Vec3d c = x.cross(y) * scale;
        Affine result;
        result.x = {a.x, b.x, c.x};
        result.y = {a.y, b.y, c.y};
        result.z = {a.z, b.z, c.z};
        result.origin = -result.vector(origin);
        return result;
    }
};

/// Where something stands: its map, the inverse, and how normals go.
struct Placement {
    Affine to_world;
    Affine to_object;  // the identity when the map has no inverse
    Affine normals;    // inverse transpose, times the size of the determinant; no translation
    bool is_invertible = true;
    bool mirrors = false;  // the determinant is negative

    Placement() = default;
    explicit Placement(const Matrix& matrix) : Placement(Affine(matrix)) {}
    explicit Placement(const Affine& map)
        : to_world(map), is_invertible(map.is_invertible()), mirrors(map.determinant() < 0) {
        if (is_invertible) to_object = map.inverse();
        const double sign = mirrors ? -1 : 1;
        normals.x = map.y.cross(map.z) * sign;
        normals.y = map.z.cross(map.x) * sign;
        normals.z = map.x.cross(map.y) * sign;
    }

    /// The normal of the image of a surface on the same side of it; any length.
    Vec3d normal(const Vec3d& n) const { return normals.vector(n); }
};

}  // namespace sunfleck::engine
