// Decoders of image formats, from which read_image.cpp selects. Each throws Error for a damaged or
// truncated file, and for one that claims more pixels than it can hold.
#pragma once

#include "image/image.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

Image parse_png_image(std::string_view bytes, const std::string& name, const Encoding& encoding);
/// Decodes grey, RGB or CMYK of 8 bits.
Image parse_jpeg(std::string_view bytes, const std::string& name);
/// Decodes RGB or RGBA of 8 bits; of films nothing.
Image parse_webp(std::string_view bytes, const std::string& name);
/// Decodes 8-bit grey, 15 to 32-bit colours and palettes, plain or run-length; alpha is dropped.
Image parse_tga(std::string_view bytes, const std::string& name);
/// Decodes the channels that exr_colours() selects. The result has halves if all channels are
/// halves.
Image parse_exr_image(std::string_view bytes, const std::string& name);
/// Decodes Radiance RGBE with rows from the top, as floats.
Image parse_hdr(std::string_view bytes, const std::string& name);
/// Decodes a portable float map, grey or RGB, of either byte order; the size of its scale
/// multiplies the values.
Image parse_pfm(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
