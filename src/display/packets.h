// Packets of the protocol by which tev is told of pictures (https://github.com/Tom94/tev, "Over the
// Network", and what src/Ipc.cpp reads there).
//
// A packet is the number of its bytes (4 bytes), its kind (1 byte), and what the kind has. Numbers
// are little-endian, texts end with a zero byte.
#pragma once

#include "image/picture.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// A part of a picture that one packet holds.
struct DisplayBlock {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    std::size_t first_channel = 0;
    std::size_t channels = 0;
};

/// Returns the packet that makes a black image of the picture's size and channels, in place of one
/// of that name. @param selects  whether the image is the one that is looked at then.
std::string create_packet(const std::string& name, const Picture& picture, bool selects);

/// Returns blocks that cover the picture, at most 128 x 128 pixels of three channels each, so that
/// no packet is large: the first three channels of all pixels, which are R, G and B, come first.
std::vector<DisplayBlock> blocks_of(const Picture& picture);

/// Returns the packet that replaces the block's pixels in the image of that name.
std::string update_packet(const std::string& name, const Picture& picture,
                          const DisplayBlock& block);

}  // namespace sunfleck::engine
