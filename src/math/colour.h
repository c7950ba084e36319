// Colorimetry: the CIE 1931 observer, the white of sRGB, and linear sRGB of a wavelength.
//
// Scale: a radiance L(nm) has XYZ = integral of L times observer / 106.856895 nm (pbrt-v4). Hence
// the constant 1 has luminance Y = 1, and D65 of luminance one is the white (1,1,1).
// Source: CIE 15:2004; sRGB: IEC 61966-2-1.
#pragma once

#include "math/triple.h"

#include <array>
#include <cstddef>

namespace sunfleck::engine {

/// Range of the observer's tables; radiance outside it is invisible.
inline constexpr int kFirstNm = 360;
inline constexpr int kLastNm = 830;
inline constexpr std::size_t kVisibleCount = 471;
/// Integral of the observer's y over wavelength in nm, rounded as in pbrt-v4.
inline constexpr double kYIntegral = 106.856895;

/// Luminance weights of linear sRGB: the Y row of the matrix to XYZ as printed in IEC 61966-2-1.
inline constexpr Triple kLuminanceWeights = {0.2126, 0.7152, 0.0722};

/// Returns a table in steps of 1 nm, kFirstNm..kLastNm: linear sRGB of a radiance of one per nm.
/// The colour of a radiance is the sum of radiance times response. The sum of all responses is the
/// colour of the constant 1.
const std::array<Triple, kVisibleCount>& rgb_response();

/// Interpolates the table linearly, for nm in [kFirstNm, kLastNm].
Triple rgb_response(double nm);

/// Returns the standard illuminant D65 in steps of 1 nm, scaled to luminance one.
const std::array<double, kVisibleCount>& white();

/// Returns the observer's y in steps of 1 nm, divided by kYIntegral.
const std::array<double, kVisibleCount>& luminance_response();

/// Converts between linear sRGB and XYZ. The white point equals that of white() to the last bits.
Triple xyz_of_rgb(const Triple& rgb);
Triple rgb_of_xyz(const Triple& xyz);

}  // namespace sunfleck::engine
