// A picture to be compared: linear RGB in floats, from any file that we read.
#pragma once

#include "math/colour.h"
#include "math/vector.h"

#include <cstddef>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct RgbImage {
    int width = 0;
    int height = 0;
    std::vector<Vec3> pixels;  // linear sRGB, row after row from the top
};

/// Reads a picture. A grey one counts as R = G = B; alpha is ignored.
/// @throws Error for what cannot be read (parse_image).
RgbImage read_rgb(const std::string& path);

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Pixels of which a channel is NaN or infinite.
std::size_t broken_pixels(const RgbImage& image);

inline float luminance(const Vec3& rgb) {
    const auto weight = [](std::size_t c) { return static_cast<float>(kLuminanceWeights[c]); };
    return weight(0) * rgb.x + weight(1) * rgb.y + weight(2) * rgb.z;
}

}  // namespace sunfleck::engine
