// White balance: what makes an illuminant of a given temperature white.
#pragma once

#include "math/colour_matrix.h"

namespace sunfleck::engine {

/// CIE chromaticities.
struct Chromaticity {
    double x = 0;
    double y = 0;
};

/// Of the CIE daylight of a temperature; below 4000 K, where there is none, of the blackbody (as
/// pbrt-v4). Source: CIE 15:2004, 3.1; the temperature is scaled by 1.4388 / 1.4380 (c2 of today
/// over that of the definition). @param kelvin  positive; above 25,000 as 25,000.
Chromaticity daylight(double kelvin);

/// A matrix on linear sRGB, by rows, that takes the colour of daylight(kelvin) to white (D65), by
/// adapted(), as pbrt-v4 does for "whitebalance".
Rows white_balance(double kelvin);

}  // namespace sunfleck::engine
