// JPEG files: writing of pictures as baseline JFIF.
#pragma once

#include "image/output_transform.h"
#include "image/picture.h"

#include <string>

namespace sunfleck::engine {

inline constexpr int kUsualJpegQuality = 95;

/// Writes the channels R, G, B as 8-bit sRGB, atomically. The same picture gives the same bytes on
/// every run. Colour has the resolution of light from a quality of 90 on, and half of it below.
/// @param quality  1 to 100, as libjpeg counts.
/// @throws Error  if a side is longer than 65,500 pixels or the file cannot be written.
void write_jpeg(const std::string& path, const Picture& picture,
                const OutputTransform& transform = {}, int quality = kUsualJpegQuality);

}  // namespace sunfleck::engine
