// Writing of pictures in the format that the file name's ending selects.
#pragma once

#include "image/picture.h"

#include <string>

namespace sunfleck::engine {

/// Stops of exposure, up or down.
inline constexpr double kMostExposure = 100;

struct PictureFileOptions {
    float exposure = 0;  // stops; used by formats of limited range (.png)
    bool half = false;   // 16-bit floats in .exr
};

/// Returns whether the ending is that of a picture format.
bool is_picture_path(const std::string& path);

/// Returns whether the format of the ending stores R, G, B alone.
bool loses_aovs(const std::string& path);

/// Checks, before long work, that the ending is known and that the file can be written.
/// @throws Error  that lists the known endings.
void check_picture_path(const std::string& path);

/// Writes the picture atomically in the format of the ending. A .png holds R, G, B alone.
/// @throws Error  if the ending is unknown or the file cannot be written.
void write_picture(const std::string& path, const Picture& picture,
                   const PictureFileOptions& options = {});

}  // namespace sunfleck::engine
