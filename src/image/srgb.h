// The sRGB transfer curve between linear light and encoded values, both in [0,1].
//
// Source: IEC 61966-2-1:1999.
#pragma once

#include <cmath>
#include <cstdint>

namespace sunfleck::engine {

/// Encoded value of linear light; below 0 and NaN give 0, above 1 gives 1.
inline float srgb_encode(float linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    if (linear <= 0.0031308F) return 12.92F * linear;
    return 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

/// Linear light of an encoded value in [0,1].
inline float srgb_decode(float encoded) {
    if (encoded <= 0.04045F) return encoded / 12.92F;
    return std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

/// The nearest of the 256 encoded levels.
inline std::uint8_t srgb_byte(float linear) {
    return static_cast<std::uint8_t>(std::lround(255 * srgb_encode(linear)));
}

}  // namespace sunfleck::engine
