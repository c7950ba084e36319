// Image lookup with scale and inversion.
#include "texture/image_kind.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

std::array<float, 4> texel(const ImageKind& m, const TexturePoint& point) {
    const Vec2 st = place(m.mapping, point);
    const Vec2 from_top(st.x, 1 - st.y);
    return m.nearest ? nearest(*m.image, from_top, m.wraps) : bilinear(*m.image, from_top, m.wraps);
}

float scaled(const ImageKind& m, float value) {
    const float v = m.scale * value;
    return m.invert ? std::max(0.0F, 1 - v) : v;
}

}  // namespace

float image_number(const FloatImageKind& image, const TexturePoint& point) {
    const std::array<float, 4> v = texel(image, point);
    if (image.image->channels() == 1) return scaled(image, v[0]);
    if (image.image->channels() == 4) return scaled(image, v[3]);
    return scaled(image, (v[0] + v[1] + v[2]) / 3);
}

Vec3 image_rgb(const ImageKind& image, const TexturePoint& point) {
    const std::array<float, 4> v = texel(image, point);
    const bool grey = image.image->channels() == 1;
    const auto channel = [&](std::size_t c) {
        const float value = scaled(image, v.at(grey ? 0 : c));
        return value > 0 ? value : 0;  // also for NaN
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace sunfleck::engine
