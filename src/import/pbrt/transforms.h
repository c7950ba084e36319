// The matrices of the transform directives, as row vectors have them.
#pragma once

#include "math/vector.h"

#include <optional>

namespace sunfleck::engine {

Matrix translation(const Vec3d& by);
Matrix scaling(const Vec3d& by);

/// By `degrees` about an axis of any length but zero, counter-clockwise when it points at the
/// viewer of a right-handed frame (Rodrigues).
Matrix rotation(double degrees, const Vec3d& axis);

/// World to camera: the camera at `eye` looks along +z at `target`, x right, y up (left-handed).
/// Nothing if the points are the same or `up` points at the target.
std::optional<Matrix> look_at(const Vec3d& eye, const Vec3d& target, const Vec3d& up);

/// The matrix on the way from one to another: translations and stretches are mixed linearly,
/// rotations turn evenly about one axis, the shorter way. One that would have no inverse gives
/// `from`. @param share  in [0, 1]; 0 gives `from`.
/// Source: Shoemake and Duff, Matrix Animation and Polar Decomposition (1992), as pbrt-v4.
Matrix between(const Matrix& from, const Matrix& to, double share);

/// Finite, affine, and with an inverse?
bool is_usable(const Matrix& matrix);

}  // namespace sunfleck::engine
