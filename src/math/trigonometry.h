// Sine and cosine in double with the same bits on every machine: + - * / alone.
//
// In:  a fraction of a turn (so that reducing the range is exact). Out: sine and cosine, within
// 3e-16 of the truth. The library's double versions differ in last bits between CPUs.
// Source: Taylor's series on [-pi/4, pi/4], cut where the next term is below 5e-18.
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

/// a[0] + a[1] x + a[2] x^2 + ..., from the last term down.
template <std::size_t N>
constexpr double horner(const std::array<double, N>& a, double x) {
    double value = a[N - 1];
    for (std::size_t i = N - 1; i-- > 0;) value = value * x + a[i];
    return value;
}

/// The terms of sine after x, and of cosine after 1 - x^2 / 2: (-1)^k / (2k + 1)! and / (2k)!.
inline constexpr std::array kSineTerms = {
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
inline constexpr std::array kCosineTerms = {
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};

/// Sine and cosine of an eighth of a turn at most. @param angle  in radians, |angle| <= pi / 4.
constexpr SinCos sin_cos_small(double angle) {
    const double square = angle * angle;
    return {angle + angle * square * horner(kSineTerms, square),
            1 - (square / 2 - square * square * horner(kCosineTerms, square))};
}

/// Sine and cosine of 2 pi times `fraction`. @param fraction  any finite number; |fraction| < 2^50
/// keeps the promised accuracy relative to the given double. Multiples of 1/4 give exact values.
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
