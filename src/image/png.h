// PNG files: 8-bit sRGB pictures to look at, and the encoded values of any PNG.
#pragma once

#include "image/picture.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Writes the channels R, G, B as 8-bit sRGB, atomically.
/// @param exposure  in stops: light is multiplied by 2^exposure first.
/// @throws Error if the file cannot be written.
void write_png(const std::string& path, const Picture& picture, float exposure = 0);

/// The values as the file has them, not decoded to light.
struct PngImage {
    int width = 0;
    int height = 0;
    int channels = 0;                   // 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha
    int bits = 8;                       // 8 or 16: values lie in [0, 2^bits - 1]
    std::vector<std::uint16_t> values;  // pixel after pixel, row after row from the top

    /// Value of a channel, scaled to [0,1].
    float at(int x, int y, int channel) const {
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x);
        const auto i = pixel * static_cast<std::size_t>(channels);
        return static_cast<float>(values[i + static_cast<std::size_t>(channel)]) /
               static_cast<float>(bits == 8 ? 255 : 65535);
    }
};

/// Reads any PNG: palettes and 1, 2, 4 bits become 8 bits; colour-space chunks are ignored.
/// @throws Error for what is no PNG, is cut or damaged, or claims more than its size can hold.
PngImage read_png(const std::string& path);
/// The same of a file in memory. @param name  for messages.
PngImage parse_png(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
