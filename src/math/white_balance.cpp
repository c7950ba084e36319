// Adaptation from one white to another in Bradford's cone space.
#include "math/white_balance.h"

#include "math/spectral_curve.h"

#include <algorithm>

namespace sunfleck {
namespace {

using Rows = std::array<Triple, 3>;

constexpr Rows kBradford = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

Triple times(const Rows& m, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

/// The solution of m x = v, by Cramer's rule.
Triple solved(const Rows& m, const Triple& v) {
    const auto determinant = [](const Rows& a) {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
               a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    Triple x{};
    for (std::size_t column = 0; column < 3; ++column) {
        Rows replaced = m;
        for (std::size_t row = 0; row < 3; ++row) replaced[row][column] = v[row];
        x[column] = determinant(replaced) / determinant(m);
    }
    return x;
}

Chromaticity chromaticity(const Triple& xyz) {
    const double sum = xyz[0] + xyz[1] + xyz[2];
    return {xyz[0] / sum, xyz[1] / sum};
}

}  // namespace

Chromaticity daylight(double kelvin) {
    const double t = std::min(kelvin * 1.4388 / 1.4380, 25000.0);
    if (t < 4000) {
        const SpectralCurve blackbody(BlackbodyCurve{static_cast<float>(kelvin)});
        const Vec3 rgb = blackbody.to_rgb();
        return chromaticity(xyz_of_rgb({rgb.x, rgb.y, rgb.z}));
    }
    const double v = 1000 / t;
    const double x = t <= 7000 ? ((-4.6070 * v + 2.9678) * v + 0.09911) * v + 0.244063
                               : ((-2.0064 * v + 1.9018) * v + 0.24748) * v + 0.237040;
    return {x, (-3 * x + 2.870) * x - 0.275};
}

Rows white_balance(double kelvin) {
    const Chromaticity from = daylight(kelvin);
    const Triple source = {from.x / from.y, 1, (1 - from.x - from.y) / from.y};
    const Triple cones = times(kBradford, source);
    const Triple wanted = times(kBradford, xyz_of_rgb({1, 1, 1}));
    Rows balance{};
    for (std::size_t column = 0; column < 3; ++column) {
        Triple unit{};
        unit[column] = 1;
        Triple adapted = times(kBradford, xyz_of_rgb(unit));
        for (std::size_t i = 0; i < 3; ++i) adapted[i] *= wanted[i] / cones[i];
        const Triple rgb = rgb_of_xyz(solved(kBradford, adapted));
        for (std::size_t row = 0; row < 3; ++row) balance[row][column] = rgb[row];
    }
    return balance;
}

}  // namespace sunfleck
