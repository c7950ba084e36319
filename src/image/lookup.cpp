// Lookups in images.
#include "image/lookup.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

using Values = std::array<float, 4>;

int modulo(int i, int n) {
    const int rest = i % n;
    return rest < 0 ? rest + n : rest;
}

/// Texel numbers brought to the other side of the edge that they are beyond.
void fold(int& along, int& across, int n, int across_n) {
    if (along >= 0 && along < n) return;
    along = along < 0 ? -1 - along : 2 * n - 1 - along;
    across = across_n - 1 - across;
}

Values texel(const Image& image, int x, int y, Wrap wrap) {
    const Vec2i& n = image.resolution();
    const bool inside = x >= 0 && x < n.x && y >= 0 && y < n.y;
    if (!inside) {
        if (wrap == Wrap::black) return {};
        if (wrap == Wrap::repeat) return image.at(modulo(x, n.x), modulo(y, n.y));
        if (wrap == Wrap::octahedral_sphere) {
            fold(x, y, n.x, n.y);
            fold(y, x, n.y, n.x);
        }
        x = std::clamp(x, 0, n.x - 1);
        y = std::clamp(y, 0, n.y - 1);
    }
    return image.at(x, y);
}

/// A place in texels, always one that an int can hold.
float in_texels(float place, int n) {
    constexpr float kFar = 1e9F;
    const float x = place * static_cast<float>(n);
    return x >= -kFar && x <= kFar ? x : 0;
}

}  // namespace

std::array<float, 4> bilinear(const Image& image, const Vec2& place, Wrap wrap) {
    const float x = in_texels(place.x, image.resolution().x) - 0.5F;
    const float y = in_texels(place.y, image.resolution().y) - 0.5F;
    const float left = std::floor(x);
    const float top = std::floor(y);
    const auto column = static_cast<int>(left);
    const auto row = static_cast<int>(top);
    const Values v00 = texel(image, column, row, wrap);
    const Values v10 = texel(image, column + 1, row, wrap);
    const Values v01 = texel(image, column, row + 1, wrap);
    const Values v11 = texel(image, column + 1, row + 1, wrap);
    const float right = x - left;
    const float below = y - top;
    Values result;
    for (std::size_t c = 0; c < result.size(); ++c) {
        const float upper = v00[c] * (1 - right) + v10[c] * right;
        const float lower = v01[c] * (1 - right) + v11[c] * right;
        result[c] = upper * (1 - below) + lower * below;
    }
    return result;
}

std::array<float, 4> nearest(const Image& image, const Vec2& place, Wrap wrap) {
    const float x = std::floor(in_texels(place.x, image.resolution().x));
    const float y = std::floor(in_texels(place.y, image.resolution().y));
    return texel(image, static_cast<int>(x), static_cast<int>(y), wrap);
}

}  // namespace sunfleck::engine
