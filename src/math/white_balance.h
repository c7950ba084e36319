// White balance: the matrix that makes an illuminant of a given temperature white.
#pragma once

#include "math/colour_matrix.h"

namespace sunfleck::engine {

/// CIE chromaticity coordinates.
struct Chromaticity {
    double x = 0;
    double y = 0;
};

/// Returns the chromaticity of CIE daylight; below 4000 K, where it is undefined, of the blackbody,
/// as in pbrt-v4. The temperature is scaled by 1.4388 / 1.4380, today's c2 over that of the
/// definition. Source: CIE 15:2004, 3.1.
/// @param kelvin  positive; values above 25,000 count as 25,000.
Chromaticity daylight(double kelvin);

/// Returns a matrix on linear sRGB, by rows, that takes the colour of daylight(kelvin) to D65 by
/// adapted(), as pbrt-v4 does for "whitebalance".
Rows white_balance(double kelvin);

}  // namespace sunfleck::engine
