// Sampling of covers.
#include "export/masks.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {

UvBox uv_box(const PlacedShape& shape) {
    const auto* mesh = std::get_if<TriangleMesh>(&shape.shape);
    Vec2 low(0, 0);
    Vec2 high(1, 1);
    if (mesh != nullptr)
        for (const Vec2& uv : mesh->uvs) {
            low = {std::min(low.x, std::floor(uv.x)), std::min(low.y, std::floor(uv.y))};
            high = {std::max(high.x, std::ceil(uv.x)), std::max(high.y, std::ceil(uv.y))};
        }
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

FloatTexture mask_of(const Cover& cover, const UvBox& box) {
    const Vec2 low(box[0], box[1]);
    const Vec2 size(box[2], box[3]);
    std::vector<std::uint8_t> texels;
    texels.reserve(std::size_t{kMaskSide} * kMaskSide);
    Hit hit{};
    const auto place = [](int i) { return (static_cast<float>(i) + 0.5F) / kMaskSide; };
    for (int y = 0; y < kMaskSide; ++y)
        for (int x = 0; x < kMaskSide; ++x) {
            hit.uv = low + size * Vec2(place(x), 1 - place(y));
            const float alpha = std::clamp(cover(hit), 0.0F, 1.0F);
            texels.push_back(static_cast<std::uint8_t>(alpha * 255 + 0.5F));
        }
    FloatImageKind kind;
    kind.image = std::make_shared<const Image>(Vec2i(kMaskSide, kMaskSide), 1, std::move(texels),
                                               Encoding{Encoding::Kind::linear, 1});
    kind.mapping = UvMapping{Vec2(1) / size, -low / size};
    kind.wraps = Wrap::clamp;
    kind.nearest = true;
    return FloatTexture(FloatKind{std::move(kind)});
}

}  // namespace sunfleck::engine
