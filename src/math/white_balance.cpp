// Chromaticities of daylight, and the matrix that makes one of them white.
#include "math/white_balance.h"

#include "math/colour.h"
#include "math/colour_matrix.h"
#include "math/spectrum.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

Chromaticity chromaticity(const Triple& xyz) {
    const double sum = xyz[0] + xyz[1] + xyz[2];
    return {xyz[0] / sum, xyz[1] / sum};
}

}  // namespace

Chromaticity daylight(double kelvin) {
    const double t = std::min(kelvin * 1.4388 / 1.4380, 25000.0);
    if (t < 4000) {
        const Spectrum blackbody(BlackbodySpectrum{static_cast<float>(kelvin)});
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
    Rows balance{};
    for (std::size_t column = 0; column < 3; ++column) {
        Triple unit{};
        unit[column] = 1;
        const Triple rgb = rgb_of_xyz(adapted(xyz_of_rgb(unit), source, xyz_of_rgb({1, 1, 1})));
        for (std::size_t row = 0; row < 3; ++row) balance[row][column] = rgb[row];
    }
    return balance;
}

}  // namespace sunfleck::engine
