// Texels of images.
#include "image/image.h"

#include "image/srgb.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

constexpr float kGreatestHalf = 65504;

float Encoding::decode(float value) const {
    switch (kind) {
        case Kind::srgb:
            return srgb_decode(value);
        case Kind::gamma:
            return std::pow(value, exponent);
        default:
            return value;
    }
}

Image::Image(const Vec2i& resolution, int channels, Texels texels, const Encoding& encoding)
    : resolution_(resolution), channels_(channels), texels_(std::move(texels)) {
    for (std::size_t i = 0; i < light_.size(); ++i)
        light_[i] = encoding.decode(static_cast<float>(i) / 255);
}

std::array<float, 4> Image::at(int x, int y) const {
    const auto count = static_cast<std::size_t>(channels_);
    const std::size_t first =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(resolution_.x) +
         static_cast<std::size_t>(x)) *
        count;
    return std::visit(
        [&]<class T>(const std::vector<T>& texels) {
            std::array<float, 4> values{};
            for (std::size_t c = 0; c < count; ++c) {
                if constexpr (std::is_same_v<T, std::uint8_t>)
                    values.at(c) = light_[texels[first + c]];
                else
                    values.at(c) = static_cast<float>(texels[first + c]);
            }
            return values;
        },
        texels_);
}

Image Image::with_channels(int count) const {
    Image result = *this;
    result.channels_ = count;
    const auto from = static_cast<std::size_t>(channels_);
    const auto kept = static_cast<std::size_t>(count);
    std::visit(
        [&]<class T>(std::vector<T>& texels) {
            const std::size_t all = texels.size() / from;
            for (std::size_t i = 0; i < all; ++i)
                for (std::size_t c = 0; c < kept; ++c) texels[i * kept + c] = texels[i * from + c];
            texels.resize(all * kept);
            texels.shrink_to_fit();
        },
        result.texels_);
    return result;
}

void Image::mend_broken() {
    const auto count = static_cast<std::size_t>(channels_);
    std::size_t last = 0;  // one behind the last broken texel
    const auto note = [&](std::size_t texel) {
        if (texel + 1 == last) return;
        last = texel + 1;
        const auto width = static_cast<std::size_t>(resolution_.x);
        if (broken_.count == 0)
            broken_.first = {static_cast<int>(texel % width), static_cast<int>(texel / width)};
        ++broken_.count;
    };
    std::visit(
        [&]<class T>(std::vector<T>& texels) {
            if constexpr (!std::is_same_v<T, std::uint8_t>)
                for (std::size_t i = 0; i < texels.size(); ++i) {
                    const auto value = static_cast<float>(texels[i]);
                    if (std::isfinite(value)) continue;
                    texels[i] = T(value > 0 ? kGreatestHalf : 0.0F);
                    note(i / count);
                }
        },
        texels_);
}

bool Image::has_holes() const {
    if (channels_ != 4) return false;
    for (int y = 0; y < resolution_.y; ++y)
        for (int x = 0; x < resolution_.x; ++x)
            if (at(x, y)[3] != 1) return true;
    return false;
}

}  // namespace sunfleck::engine
