// The decoders that read_image.cpp chooses from, one a file. Each throws Error for what is damaged,
// cut, or claims more pixels than its size can hold.
#pragma once

#include "image/image.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

Image parse_png_image(std::string_view bytes, const std::string& name, const Encoding& encoding);
/// Grey, RGB, or the inks CMYK, 8 bits.
Image parse_jpeg(std::string_view bytes, const std::string& name);
/// 8-bit grey, 15 to 32-bit colours, palettes, each plain or packed in runs; alpha is dropped.
Image parse_tga(std::string_view bytes, const std::string& name);
/// Channels R, G, B and perhaps A; X, Y, Z of CIE; those of the only layer that has such; or a
/// single one of any name. Halves if all are.
Image parse_exr_image(std::string_view bytes, const std::string& name);
/// Radiance's RGBE with rows from the top, as floats.
Image parse_hdr(std::string_view bytes, const std::string& name);
/// Portable float map, grey or RGB, of either byte order; times the size of its scale.
Image parse_pfm(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
