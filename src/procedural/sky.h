// A clear sky as a picture for an infinite light.
#pragma once

#include "math/vector.h"

#include <string>

namespace sunfleck::engine {

/// The sky without the sun's disc, in an equal-area octahedral map (uniform_sphere() in
/// math/warp.h, z up), as the bytes of a PFM file in linear sRGB. The lower half is a dim ground.
/// Scaled so that the sky gives a horizontal plane an illuminance (luminance times cosine) of one.
/// Source: Preetham, Shirley and Smits, A Practical Analytic Model for Daylight (1999), appendix;
/// turbidity 3.
/// @param sun   unit vector to the sun, above the horizon. @param side  of the picture, in texels.
std::string clear_sky_pfm(const Vec3d& sun, int side);

}  // namespace sunfleck::engine
