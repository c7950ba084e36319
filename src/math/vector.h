// Short names for the linear algebra that we use, and the few helpers that it lacks.
#pragma once

#include <ImathMatrix.h>
#include <ImathVec.h>

#include <cmath>

namespace sunfleck::engine {

// Like numbers that are not initialised, Vec2{} and Vec3{} have no value: zero is Vec3(0).
using Vec2 = Imath::V2f;
using Vec2d = Imath::V2d;
using Vec2i = Imath::V2i;
using Vec3 = Imath::V3f;
using Vec3d = Imath::V3d;
/// Row vectors: point * matrix, as Imath has it; the translation is the last row.
using Matrix = Imath::M44d;

inline constexpr float kPi = 3.14159265358979F;
inline constexpr double kPiDouble = 3.14159265358979323846;

/// A right-handed orthonormal frame around a unit normal: local +z is the normal.
/// Source: Duff et al., Building an Orthonormal Basis, Revisited (JCGT 2017).
struct Frame {
    Vec3 x;
    Vec3 y;
    Vec3 z;

    explicit Frame(const Vec3& normal) : z(normal) {
        const float sign = std::copysign(1.0F, normal.z);
        const float a = -1 / (sign + normal.z);
        const float b = normal.x * normal.y * a;
        x = Vec3(1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
        y = Vec3(b, sign + normal.y * normal.y * a, -normal.y);
    }

    /// Local +z is the normal; local +x is the part of `tangent` that is perpendicular to it.
    /// A tangent that is zero or along the normal gives Frame(normal).
    Frame(const Vec3& normal, const Vec3& tangent) : z(normal) {
        const Vec3 flat = tangent - normal * normal.dot(tangent);
        const float length2 = flat.length2();
        if (!(length2 > 1e-12F * tangent.length2())) {
            *this = Frame(normal);
            return;
        }
        x = flat * (1 / std::sqrt(length2));
        y = z.cross(x);
    }

    Vec3 to_local(const Vec3& v) const { return {v.dot(x), v.dot(y), v.dot(z)}; }
    Vec3 to_world(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
};

}  // namespace sunfleck::engine
