// Image lookup: texel indices, wrap modes, interpolation.
#include "image/lookup.h"

#include <algorithm>
#include <optional>

namespace sunfleck::engine {
namespace {

using Values = std::array<float, 4>;

int modulo(int i, int n) {
    const int rest = i % n;
    return rest < 0 ? rest + n : rest;
}

/// Maps a texel index beyond an edge of an octahedral map to the adjacent edge.
void fold(int& along, int& across, int n, int across_n) {
    if (along >= 0 && along < n) return;
    along = along < 0 ? -1 - along : 2 * n - 1 - along;
    across = across_n - 1 - across;
}

/// Returns the index of a texel within the image, or nothing for one that is black.
std::optional<int> within(int i, int n, Wrap wrap) {
    if (i >= 0 && i < n) return i;
    if (wrap == Wrap::black) return {};
    if (wrap == Wrap::repeat) return modulo(i, n);
    if (wrap == Wrap::mirror) {
        const int twice = modulo(i, 2 * n);
        return twice < n ? twice : 2 * n - 1 - twice;
    }
    return std::clamp(i, 0, n - 1);
}

Values texel(const Image& image, int x, int y, const Wraps& wraps) {
    const Vec2i& n = image.resolution();
    if (wraps.across == Wrap::octahedral_sphere) {
        fold(x, y, n.x, n.y);
        fold(y, x, n.y, n.x);
    }
    const auto column = within(x, n.x, wraps.across);
    const auto row = within(y, n.y, wraps.down);
    return column && row ? image.at(*column, *row) : Values{};
}

/// Converts a coordinate to texels, limited to the range of int.
float in_texels(float place, int n) {
    constexpr float kFar = 1e9F;
    const float x = place * static_cast<float>(n);
    return x >= -kFar && x <= kFar ? x : 0;
}

}  // namespace

std::array<float, 4> bilinear(const Image& image, const Vec2& place, const Wraps& wraps) {
    const float x = in_texels(place.x, image.resolution().x) - 0.5F;
    const float y = in_texels(place.y, image.resolution().y) - 0.5F;
    const float left = std::floor(x);
    const float top = std::floor(y);
    const auto column = static_cast<int>(left);
    const auto row = static_cast<int>(top);
    const Values v00 = texel(image, column, row, wraps);
    const Values v10 = texel(image, column + 1, row, wraps);
    const Values v01 = texel(image, column, row + 1, wraps);
    const Values v11 = texel(image, column + 1, row + 1, wraps);
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

std::array<float, 4> nearest(const Image& image, const Vec2& place, const Wraps& wraps) {
    const float x = std::floor(in_texels(place.x, image.resolution().x));
    const float y = std::floor(in_texels(place.y, image.resolution().y));
    return texel(image, static_cast<int>(x), static_cast<int>(y), wraps);
}

}  // namespace sunfleck::engine
