// Texels at a place, scaled and inverted.
#include "texture/image_kind.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

std::array<float, 4> texel(const ImageKind& m, const TexturePoint& point) {
    const Vec2 st = place(m.mapping, point);
    const Vec2 from_top(st.x, 1 - st.y);
    return m.nearest ? nearest(*m.image, from_top, m.wrap) : bilinear(*m.image, from_top, m.wrap);
}

float scaled(const ImageKind& m, float value) {
    const float v = m.scale * value;
    return m.invert ? std::max(0.0F, 1 - v) : v;
}

}  // namespace

float image_number(const FloatImageKind& m, const TexturePoint& point) {
    const std::array<float, 4> v = texel(m, point);
    if (m.image->channels() == 1) return scaled(m, v[0]);
    if (m.image->channels() == 4) return scaled(m, v[3]);
    return scaled(m, (v[0] + v[1] + v[2]) / 3);
}

Vec3 image_rgb(const ImageKind& m, const TexturePoint& point) {
    const std::array<float, 4> v = texel(m, point);
    const bool grey = m.image->channels() == 1;
    const auto channel = [&](std::size_t c) {
        const float value = scaled(m, v.at(grey ? 0 : c));
        return value > 0 ? value : 0;  // NaN, too
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace sunfleck::engine
