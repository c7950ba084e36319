// Gradient noise, and fractal sums of it.
//
// Source: Perlin, Improving Noise (SIGGRAPH 2002); fBm and turbulence as in pbrt-v4 (Pharr, Jakob,
// Humphreys, Physically Based Rendering, 4th edition, online section 10.6), so that scenes look
// alike.
#pragma once

#include "math/vector.h"

namespace sunfleck::engine {

/// Returns noise in about [-1,1], zero at integers, with period 256 along each axis.
float noise(const Vec3& p);

/// Octaves; each one has 1.99 times the frequency of the one before, and `roughness` times its
/// amplitude.
struct Octaves {
    int count = 8;
    float roughness = 0.5F;
};

/// Returns the sum of noise over the octaves.
float fbm(const Vec3& p, const Octaves& octaves);
/// Returns the sum of |noise| over the octaves, plus 0.2 for the mean of the next one.
float turbulence(const Vec3& p, const Octaves& octaves);

}  // namespace sunfleck::engine
