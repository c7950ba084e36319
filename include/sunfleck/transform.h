// Affine maps that place cameras, lights and shapes.
#pragma once

#include <sunfleck/export.h>

#include <array>

namespace sunfleck {

using Vector = std::array<double, 3>;

/// Maps points p to M p, as column vectors have it: a * b is first b, then a.
class SUNFLECK_API Transform {
public:
    /// Four rows of four numbers.
    using Rows = std::array<std::array<double, 4>, 4>;

    /// The identity.
    Transform() = default;
    /// @throws Error  for a matrix that is not affine, not finite, or has no inverse.
    explicit Transform(const Rows& rows);

    static Transform translate(const Vector& by);
    static Transform scale(const Vector& by);
    /// Counter-clockwise about an axis that points at the viewer.
    static Transform rotate(double degrees, const Vector& axis);
    /// The place of a camera at `eye` that looks at `target`: camera to world. The camera's frame
    /// is pbrt-v4's, left-handed: x to the right, y up, z forward.
    static Transform look_at(const Vector& eye, const Vector& target, const Vector& up);

    const Rows& rows() const { return rows_; }

    friend SUNFLECK_API Transform operator*(const Transform& a, const Transform& b);

private:
    Rows rows_{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
};

}  // namespace sunfleck
