// Channels by the name before their last dot.
#include "live/layers.h"

#include "image/exr_options.h"
#include "image/id_layers.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>

namespace sunfleck::engine {
namespace {

/// Returns the place of a channel in its layer; npos of what cannot be shown, as transparency.
std::size_t order_of(const Channel& channel) {
    constexpr std::string_view kShown = "RGBXYZ";
    return kShown.find(channel.name.back());
}

/// Returns the nearest number of 16 bits; of two as near, the even one.
std::uint16_t upper_half(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const bool is_finite = (bits & 0x7f800000U) != 0x7f800000U;
    const std::uint32_t odd = bits >> 16U & 1U;
    return static_cast<std::uint16_t>((is_finite ? bits + 0x7fffU + odd : bits) >> 16U);
}

}  // namespace

std::vector<LiveLayer> layers_of(const Picture& picture) {
    std::vector<LiveLayer> layers;
    for (const Channel& channel : picture.channels) {
        std::string name = exr_layer(channel.name);
        if (order_of(channel) == std::string_view::npos || holds_ids(picture, name)) continue;
        auto layer = std::find_if(layers.begin(), layers.end(),
                                  [&](const LiveLayer& known) { return known.name == name; });
        if (layer == layers.end()) layer = layers.insert(layer, {std::move(name), {}});
        layer->channels.push_back(&channel);
    }
    for (LiveLayer& layer : layers)
        std::sort(layer.channels.begin(), layer.channels.end(),
                  [](const Channel* a, const Channel* b) { return order_of(*a) < order_of(*b); });
    return layers;
}

std::string layer_bytes(const LiveLayer& layer) {
    std::string bytes;
    for (const Channel* channel : layer.channels) {
        bytes.reserve(2 * layer.channels.size() * channel->values.size());
        for (const float value : channel->values) {
            const std::uint16_t half = upper_half(value);
            bytes.push_back(static_cast<char>(half & 255U));
            bytes.push_back(static_cast<char>(half >> 8U));
        }
    }
    return bytes;
}

}  // namespace sunfleck::engine
