// Beer's law for colours.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

/// Returns the absorption by which so much of each colour is left after a distance.
/// @param distance  positive. @param left  at least a millionth counts.
inline Vec3d absorption_over(double distance, const Vec3d& left) {
    constexpr double kDarkest = 1e-6;
    Vec3d absorption;
    for (int c = 0; c < 3; ++c)
        absorption[c] = -std::log(std::clamp(left[c], kDarkest, 1.0)) / distance;
    return absorption;
}

}  // namespace sunfleck::engine
