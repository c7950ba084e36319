// Selects the colour channels of an OpenEXR file.
#pragma once

#include <string>
#include <vector>

namespace sunfleck::engine {

struct ExrColours {
    std::vector<std::string> channels;  // 1 grey, 3 colours, 4 colours and alpha
    bool are_xyz = false;               // CIE XYZ in place of RGB
    std::string remark;                 // a note about the choice for the user, or empty
};

/// Selects R, G, B and perhaps A; else Y, or X, Y and Z; else red, green and blue of the only layer
/// that has them, in any spelling; else the only channel.
/// @param all  names of all channels.
/// @param name  file name for errors.
/// @throws Error  for files without colours, or with colours in several layers.
ExrColours exr_colours(const std::vector<std::string>& all, const std::string& name);

}  // namespace sunfleck::engine
