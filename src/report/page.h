// The page of a comparison: one self-contained HTML file.
//
// In:  a comparison. Out: text. Pixels are 16-bit floats, so that the page can change the exposure
// and show values; FLIP maps are bytes. The page uses no network.
#pragma once

#include "compare/comparison.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// @return HTML5 in UTF-8.
std::string report_page(const Comparison& comparison);

/// Base64 with padding (RFC 4648, section 4).
std::string base64(std::span<const std::uint8_t> bytes);

/// R, G, B of each pixel as 16-bit floats, little-endian, and their scale: a power of two, below
/// one if values exceed 65504. NaN and infinity are kept.
struct HalfPixels {
    std::vector<std::uint8_t> bytes;
    float scale = 1;
};
HalfPixels half_pixels(const RgbImage& image);

}  // namespace sunfleck::engine
