// Writing of pictures in the format that the file name's ending selects.
#pragma once

#include "image/exr.h"
#include "image/jpeg.h"
#include "image/picture.h"

#include <string>

namespace sunfleck::engine {

struct PictureFileOptions {
    OutputTransform transform{};           // of .png and .jpg
    int png_bits = 8;                      // 8 or 16
    int jpeg_quality = kUsualJpegQuality;  // 1 to 100
    ExrOptions exr{};
};

/// Returns all endings of picture formats for messages: ".exr, .png, .jpg or .jpeg".
std::string picture_endings();

/// Returns whether the ending is that of a picture format.
bool is_picture_path(const std::string& path);

/// Returns whether the format of the ending stores R, G, B alone.
bool loses_aovs(const std::string& path);

/// Checks, before long work, that the ending is known and that the file can be written.
/// @throws Error  that lists the known endings, or for a date that an .exr cannot have (exr.h).
void check_picture_path(const std::string& path);

/// Writes the picture atomically in the format of the ending. A .png or .jpg holds R, G, B alone.
/// @throws Error  if the ending is unknown or the file cannot be written.
void write_picture(const std::string& path, const Picture& picture,
                   const PictureFileOptions& options = {});

}  // namespace sunfleck::engine
