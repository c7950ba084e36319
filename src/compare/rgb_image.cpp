// Any image file as linear RGB.
#include "compare/rgb_image.h"

#include "image/read_file.h"
#include "image/read_image.h"

#include <algorithm>

namespace sunfleck::engine {

RgbImage read_rgb(const std::string& path) {
    const Image image = parse_image(read_file(path), path);
    const Vec2i& size = image.resolution();
    RgbImage rgb{size.x, size.y, {}};
    rgb.pixels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) rgb.pixels.push_back(image.rgb(x, y));
    return rgb;
}

std::size_t broken_pixels(const RgbImage& image) {
    return static_cast<std::size_t>(
        std::count_if(image.pixels.begin(), image.pixels.end(),
                      [](const Vec3& pixel) { return !is_finite(pixel); }));
}

}  // namespace sunfleck::engine
