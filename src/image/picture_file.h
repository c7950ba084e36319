// The one place that knows which picture formats there are, by the ending of the file's name.
#pragma once

#include "image/picture.h"

#include <string>

namespace sunfleck::engine {

struct PictureFileOptions {
    float exposure = 0;  // stops; for formats of limited range (.png) alone
    bool half = false;   // 16-bit floats in .exr
};

/// Whether the name's ending is that of a picture.
bool is_picture_path(const std::string& path);

/// Whether a picture of the name's ending holds R, G, B alone.
bool loses_aovs(const std::string& path);

/// Tried before long work: the ending is known and the file can be written.
/// @throws Error, with the endings that there are.
void check_picture_path(const std::string& path);

/// Writes the picture in the format of the ending, atomically. A .png holds R, G, B alone.
/// @throws Error if the ending is unknown or the file cannot be written.
void write_picture(const std::string& path, const Picture& picture,
                   const PictureFileOptions& options = {});

}  // namespace sunfleck::engine
