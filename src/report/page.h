// The page of a comparison: one HTML file that holds all it needs, and opens from the disk.
//
// In:  a comparison. Out: text. Pixels go as 16-bit floats, so that the page can expose them and
// read their values; FLIP's map as bytes. Nothing of it refers to a network.
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

/// R, G, B of each pixel as 16-bit floats, little-endian, and what they were multiplied by: a power
/// of two, below one where light beyond 65504 would not fit. NaN and infinite values stay so.
struct HalfPixels {
    std::vector<std::uint8_t> bytes;
    float scale = 1;
};
HalfPixels half_pixels(const RgbImage& image);

}  // namespace sunfleck::engine
