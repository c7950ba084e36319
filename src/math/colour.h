// Colour: the CIE 1931 observer, the white of sRGB, and what a wavelength is worth in linear sRGB.
//
// Scale: a radiance L(nm) has XYZ = integral of L times observer / 106.856895 nm (pbrt-v4), so that
// the constant 1 has luminance Y = 1, and D65 of luminance one is the white (1,1,1).
// Source: CIE 15:2004; sRGB: IEC 61966-2-1.
#pragma once

#include "math/triple.h"

#include <array>
#include <cstddef>

namespace sunfleck::engine {

/// Where the observer's tables begin and end; nothing outside is seen.
inline constexpr int kFirstNm = 360;
inline constexpr int kLastNm = 830;
inline constexpr std::size_t kVisibleCount = 471;
/// Integral of the observer's y over wavelength, as pbrt-v4 rounds it, in nm.
inline constexpr double kYIntegral = 106.856895;

/// Luminance of linear sRGB: IEC 61966-2-1, the row of its matrix to XYZ, as printed.
inline constexpr Triple kLuminanceWeights = {0.2126, 0.7152, 0.0722};

/// At 1 nm, kFirstNm..kLastNm: the linear sRGB of a radiance of one per nm, so that the sum over
/// all of radiance times response is the colour. Components sum over all wavelengths to the
/// colour of the constant 1.
const std::array<Triple, kVisibleCount>& rgb_response();

/// The same between the points of the table: linear, for nm in [kFirstNm, kLastNm].
Triple rgb_response(double nm);

/// At 1 nm: the standard illuminant D65, scaled to luminance one.
const std::array<double, kVisibleCount>& white();

/// At 1 nm: the observer's y, divided by kYIntegral.
const std::array<double, kVisibleCount>& luminance_response();

/// Linear sRGB to XYZ, and back. The white point is that of white(), to the last bits.
Triple xyz_of_rgb(const Triple& rgb);
Triple rgb_of_xyz(const Triple& xyz);

}  // namespace sunfleck::engine
