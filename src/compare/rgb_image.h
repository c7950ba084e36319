// A picture to be compared: linear RGB in floats, from any file that we read.
#pragma once

#include "math/vector.h"

#include <cstddef>
#include <string>
#include <vector>

namespace sunfleck {

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

/// Luminance of linear sRGB (IEC 61966-2-1).
inline float luminance(const Vec3& rgb) {
    return 0.2126F * rgb.x + 0.7152F * rgb.y + 0.0722F * rgb.z;
}

}  // namespace sunfleck
