// Gradient noise, and sums of it at several scales.
//
// Source: Perlin, Improving Noise (SIGGRAPH 2002); fBm and turbulence as pbrt-v4 has them (Pharr,
// Jakob, Humphreys, Physically Based Rendering, 4th edition, online section 10.6), so that scenes
// look alike.
#pragma once

#include "math/vector.h"

namespace sunfleck::engine {

/// In about [-1,1], zero at whole numbers; repeats every 256 along each axis.
float noise(const Vec3& p);

/// Each octave is 1.99 times as fine as the one before and `roughness` times as strong.
struct Octaves {
    int count = 8;
    float roughness = 0.5F;
};

/// Sum of noise over the octaves.
float fbm(Vec3 p, const Octaves& octaves);
/// Sum of the size of noise over the octaves, and 0.2 for the mean of the next one.
float turbulence(Vec3 p, const Octaves& octaves);

}  // namespace sunfleck::engine
