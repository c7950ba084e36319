// Matrices between two: polar decomposition, and rotations as quaternions.
#include "geometry/quadrature.h"
#include "geometry/sweep.h"
#include "import/pbrt/transforms.h"

#include <ImathMatrixAlgo.h>
#include <ImathQuat.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

using Quaternion = Imath::Quatd;

/// matrix = stretch * rotation, for row vectors; the translation apart.
struct Parts {
    Matrix stretch;
    Quaternion rotation;
    Vec3d translation;
};

/// Higham's iteration: the mean of a matrix and its inverse transposed tends to the rotation.
Parts parts_of(const Matrix& matrix) {
    Parts parts;
    parts.translation = matrix.translation();
    Matrix flat = matrix;
    flat[3][0] = flat[3][1] = flat[3][2] = 0;
    Matrix rotation = flat;
    for (int step = 0; step < 100; ++step) {
        const Matrix next = (rotation + rotation.inverse().transposed()) * 0.5;
        const bool done = next.equalWithAbsError(rotation, 1e-14);
        rotation = next;
        if (done) break;
    }
    if (rotation.determinant() < 0) {  // a mirror is a stretch
        rotation = rotation * -1.0;
        rotation[3][3] = 1;
    }
    parts.stretch = flat * rotation.transposed();
    parts.rotation = Imath::extractQuat(rotation);
    return parts;
}

Quaternion turned(const Quaternion& from, Quaternion to, double share) {
    double cosine = from ^ to;
    if (cosine < 0) {
        to = -to;
        cosine = -cosine;
    }
    double first = 1 - share;
    double second = share;
    if (cosine < 0.9999) {
        const double angle = arc_cosine(cosine);
        first = sin_cos((1 - share) * angle).sin;
        second = sin_cos(share * angle).sin;
    }
    return (from * first + to * second).normalized();
}

}  // namespace

Matrix between(const Matrix& from, const Matrix& to, double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    const Parts a = parts_of(from);
    const Parts b = parts_of(to);
    const Matrix stretch = a.stretch * (1 - share) + b.stretch * share;
    Matrix result = stretch * turned(a.rotation, b.rotation, share).toMatrix44();
    const Vec3d moved = a.translation * (1 - share) + b.translation * share;
    result[3][0] = moved.x;
    result[3][1] = moved.y;
    result[3][2] = moved.z;
    result[0][3] = result[1][3] = result[2][3] = 0;
    result[3][3] = 1;
    return is_usable(result) ? result : from;
}

}  // namespace sunfleck::engine
