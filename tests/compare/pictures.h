// Small pictures made from a function of place and channel.
#pragma once

#include "compare/rgb_image.h"

namespace sunfleck::engine::testing_support {

/// @param value  value(x, y, channel).
template <class Value>
RgbImage picture(const Value& value, int width = 32, int height = 24) {
    RgbImage image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.pixels.emplace_back(value(x, y, 0), value(x, y, 1), value(x, y, 2));
    return image;
}

inline RgbImage plain(const Vec3& colour, int width = 32, int height = 24) {
    return picture([&](int, int, int c) { return colour[c]; }, width, height);
}

}  // namespace sunfleck::engine::testing_support
