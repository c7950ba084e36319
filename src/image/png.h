// PNG files: writing of sRGB pictures of 8 or 16 bits, and reading of the encoded values of any
// PNG.
#pragma once

#include "image/output_transform.h"
#include "image/picture.h"
#include "math/vector.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Writes the channels R, G, B as sRGB, atomically.
/// @param bits  of a value: 8 or 16.
/// @throws Error  if the file cannot be written.
void write_png(const std::string& path, const Picture& picture,
               const OutputTransform& transform = {}, int bits = 8);

/// Returns the bytes of a file of 8-bit values as they are.
/// @param channels  1 grey, 3 RGB, 4 RGB and alpha.
/// @param values  pixel by pixel, row by row from the top.
std::string png_bytes(const Vec2i& size, int channels, std::span<const std::uint8_t> values);

/// The encoded values of a file, not decoded to linear light.
struct PngImage {
    int width = 0;
    int height = 0;
    int channels = 0;                   // 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha
    int bits = 8;                       // 8 or 16; values are in [0, 2^bits - 1]
    std::vector<std::uint16_t> values;  // pixel by pixel, row by row from the top

    /// Returns the value of a channel, scaled to [0,1].
    float at(int x, int y, int channel) const {
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x);
        const auto i = pixel * static_cast<std::size_t>(channels);
        return static_cast<float>(values[i + static_cast<std::size_t>(channel)]) /
               static_cast<float>(bits == 8 ? 255 : 65535);
    }
};

/// Reads any PNG: palettes and 1, 2, 4 bits become 8 bits; colour-space chunks are ignored.
/// @throws Error  for what is not PNG, is truncated or damaged, or claims more pixels than the file
/// can hold.
PngImage read_png(const std::string& path);
/// Decodes a PNG in memory. @param name  file name for messages.
PngImage parse_png(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
