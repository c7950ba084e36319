// Sine and cosine in double with the same bits on every machine: only + - * / are used.
//
// In:  an angle as a fraction of a revolution, so that range reduction is exact.
// Out: sine and cosine, within 3e-16. Those of the standard library differ in last bits between
// CPUs.
// Source: Taylor series on [-pi/4, pi/4], cut where the next term is below 5e-18.
#pragma once

#include "math/vector.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace sunfleck::engine {

struct SinCos {
    double sin = 0;
    double cos = 1;
};

/// Evaluates the polynomial a[0] + a[1] x + a[2] x^2 + ... by Horner's rule.
template <std::size_t N>
constexpr double horner(const std::array<double, N>& a, double x) {
    double value = a[N - 1];
    for (std::size_t i = N - 1; i-- > 0;) value = value * x + a[i];
    return value;
}

/// Series of sine after x, and of cosine after 1 - x^2 / 2: coefficients (-1)^k / (2k + 1)! and /
/// (2k)!.
inline constexpr std::array kSineTerms = {
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
inline constexpr std::array kCosineTerms = {
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};

/// Returns sine and cosine of a small angle. @param angle  in radians, |angle| <= pi / 4.
constexpr SinCos sin_cos_small(double angle) {
    const double square = angle * angle;
    return {angle + angle * square * horner(kSineTerms, square),
            1 - (square / 2 - square * square * horner(kCosineTerms, square))};
}

/// Returns sine and cosine of 2 pi times `fraction`; multiples of 1/4 give exact values.
/// @param fraction  any finite number; |fraction| < 2^50 keeps the stated accuracy.
inline SinCos sin_cos_2pi(double fraction) {
    const double quarters = std::floor(fraction * 4 + 0.5);
    const SinCos rest = sin_cos_small((fraction - quarters * 0.25) * (2 * kPiDouble));
    const double quadrant = quarters - 4 * std::floor(quarters * 0.25);
    if (quadrant == 0) return rest;
    if (quadrant == 1) return {rest.cos, -rest.sin};
    if (quadrant == 2) return {-rest.sin, -rest.cos};
    return {-rest.cos, rest.sin};
}

}  // namespace sunfleck::engine
