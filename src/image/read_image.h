// Reads images of all supported formats, by content: PNG, JPEG, TGA, OpenEXR, Radiance HDR, PFM.
#pragma once

#include "image/image.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Decodes a file in memory. As in pbrt-v4, 8 bits and halves are kept and 16 bits become floats;
/// grey with alpha loses the alpha, and so does an image whose alpha is one everywhere, and any
/// TGA. JPEG and TGA are sRGB whatever `encoding` says.
/// @param name  file name, for messages and for the ending of a TGA.
/// @param encoding  of a PNG, alpha included.
/// @throws Error  for an unknown, damaged or truncated format, for a file that claims more pixels
/// than it can hold, and for an EXR without colour channels.
Image parse_image(std::string_view bytes, const std::string& name, const Encoding& encoding = {});

/// Decodes as parse_image() does, but grey with alpha becomes RGBA unless the alpha is one
/// everywhere.
Image parse_image_with_alpha(std::string_view bytes, const std::string& name,
                             const Encoding& encoding = {});

}  // namespace sunfleck::engine
