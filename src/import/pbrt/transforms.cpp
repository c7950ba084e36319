// Matrices by + - * / and sqrt on doubles alone.
#include "import/pbrt/transforms.h"

#include "core/float_range.h"
#include "geometry/affine.h"
#include "math/trigonometry.h"

#include <cmath>

namespace sunfleck::engine {

Matrix translation(const Vec3d& by) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, by.x, by.y, by.z, 1};
}

Matrix scaling(const Vec3d& by) {
    return {by.x, 0, 0, 0, 0, by.y, 0, 0, 0, 0, by.z, 0, 0, 0, 0, 1};
}

Matrix rotation(double degrees, const Vec3d& axis) {
    const auto [sin, cos] = sin_cos_2pi(degrees / 360);
    const Vec3d a = axis / axis.length();
    const double rest = 1 - cos;
    return {a.x * a.x * rest + cos,
            a.x * a.y * rest + a.z * sin,
            a.x * a.z * rest - a.y * sin,
            0,
            a.x * a.y * rest - a.z * sin,
            a.y * a.y * rest + cos,
            a.y * a.z * rest + a.x * sin,
            0,
            a.x * a.z * rest + a.y * sin,
            a.y * a.z * rest - a.x * sin,
            a.z * a.z * rest + cos,
            0,
            0,
            0,
            0,
            1};
}

std::optional<Matrix> look_at(const Vec3d& eye, const Vec3d& target, const Vec3d& up) {
    const Vec3d way = target - eye;
    const double distance = way.length();
    const Vec3d z = way / distance;
    const Vec3d across = (up / up.length()).cross(z);
    const double size = across.length();
    if (!(distance > 0) || !(size > 1e-9)) return std::nullopt;
    const Vec3d x = across / size;
    const Vec3d y = z.cross(x);
    return Matrix(x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0,  //
                  -eye.dot(x), -eye.dot(y), -eye.dot(z), 1);
}

bool is_finite_float(const Matrix& m) {
    bool all = true;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) all = all && is_finite_float(m[i][j]);
    return all;
}

bool is_usable(const Matrix& m) {
    const bool affine = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
    return affine && Affine(m).is_invertible();
}

}  // namespace sunfleck::engine
