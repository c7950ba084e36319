// Matrices of the transform directives, for row vectors.
#pragma once

#include "math/vector.h"

#include <optional>

namespace sunfleck::engine {

Matrix translation(const Vec3d& by);
Matrix scaling(const Vec3d& by);

/// Returns a rotation by `degrees` about an axis of any non-zero length, counter-clockwise if the
/// axis points at the viewer of a right-handed frame (Rodrigues).
Matrix rotation(double degrees, const Vec3d& axis);

/// Returns world to camera: the camera at `eye` looks along +z at `target`, x right, y up
/// (left-handed). Nothing if the points coincide or `up` points at the target.
std::optional<Matrix> look_at(const Vec3d& eye, const Vec3d& target, const Vec3d& up);

/// Interpolates matrices: translation and scale linearly, rotation uniformly about one axis, the
/// shorter way. A singular result is replaced by `from`.
/// @param share  in [0, 1]; 0 gives `from`.
/// Source: Shoemake and Duff, Matrix Animation and Polar Decomposition (1992), as in pbrt-v4.
Matrix between(const Matrix& from, const Matrix& to, double share);

/// Returns whether each entry is a finite float.
bool is_finite_float(const Matrix& matrix);

/// Returns whether a matrix is finite, affine and invertible.
bool is_usable(const Matrix& matrix);

}  // namespace sunfleck::engine
