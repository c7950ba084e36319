// Which channels of an OpenEXR file are its colours.
#pragma once

#include <string>
#include <vector>

namespace sunfleck::engine {

struct ExrColours {
    std::vector<std::string> channels;  // 1 grey, 3 colours, 4 colours and alpha
    bool are_xyz = false;               // of CIE, not R, G and B
    std::string remark;                 // what to tell the user of the choice, or empty
};

/// R, G, B and perhaps A; else Y, or X, Y and Z; else the red, green and blue of the only layer
/// that has them, however they are written; else the only channel there is.
/// @param all  names of all channels. @param name  of the file.
/// @throws Error  for files without colours, or of several layers that have some.
ExrColours exr_colours(const std::vector<std::string>& all, const std::string& name);

}  // namespace sunfleck::engine
