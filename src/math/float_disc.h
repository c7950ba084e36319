// The concentric map from the square to the disc, in float: for directions that are floats anyway.
//
// In:  u in [0,1]^2, best multiples of 2^-24 (then 2 u - 1 is exact). Out: points within 2e-7 of
// those of concentric_disc_point(). Only + - * /: the same bits everywhere.
// Source: Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 1997).
#pragma once

#include "math/vector.h"

#include <cmath>

namespace sunfleck::engine {

/// A point of the unit disc, and how high above it the unit sphere is, squared, with all digits.
struct FloatDiscPoint {
    Vec2 position{0};
    float height2 = 1;
};

/// Taylor's series of sine and cosine for angles up to pi / 4, cut below 2e-9 and 3e-8; without a
/// branch on u, which no processor could foresee.
inline FloatDiscPoint float_disc_point(const Vec2& u) {
    const float a = 2 * u.x - 1;
    const float b = 2 * u.y - 1;
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    const float other = wide ? b : a;
    if (radius == 0) return {};
    const float angle = other / radius * (kPi / 4);
    const float x = angle * angle;
    const float sine =
        angle +
        angle * x * (-1.0F / 6 + x * (1.0F / 120 + x * (-1.0F / 5040 + x * (1.0F / 362880))));
    const float cosine = 1 - x * (0.5F - x * (1.0F / 24 - x * (1.0F / 720 - x * (1.0F / 40320))));
    const float along_x = wide ? cosine : sine;
    const float along_y = wide ? sine : cosine;
    return {{radius * along_x, radius * along_y}, (1 - radius) * (1 + radius)};
}

}  // namespace sunfleck::engine
