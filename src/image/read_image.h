// Images of any format that we read, by content: PNG, JPEG, TGA, OpenEXR, Radiance HDR, PFM.
#pragma once

#include "image/image.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Decodes a file that is in memory. As in pbrt-v4: 8 bits stay 8 bits, halves stay halves, 16 bits
/// become floats; grey with alpha loses the alpha, and so does an image whose alpha is one
/// everywhere, and any TGA. JPEG and TGA are sRGB whatever `encoding` says.
/// @param name  of the file: for messages, and for the ending of a TGA.
/// @param encoding  of a PNG, alpha included.
/// @throws Error of one line for what is none of these, is damaged, cut, or claims more than its
/// size can hold; for an EXR without channels R, G, B or a single one.
Image parse_image(std::string_view bytes, const std::string& name, const Encoding& encoding = {});

}  // namespace sunfleck::engine
