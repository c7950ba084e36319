// Bytes, in the order in which tev reads them.
#include "display/packets.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace sunfleck::engine {
namespace {

static_assert(std::endian::native == std::endian::little, "floats are sent as they stand");

constexpr int kBlockPixels = 128;  // in both directions, as pbrt-v4 sends them
constexpr std::size_t kBlockChannels = 3;

/// Kinds of packets; tev has others.
enum class PacketKind : std::uint8_t { create_image = 4, update_image_of_strides = 6 };

/// A packet that grows.
class Packet {
public:
    explicit Packet(PacketKind kind, bool selects) {
        add(std::uint32_t{0});  // finish() knows it
        add(static_cast<std::uint8_t>(kind));
        add(static_cast<std::uint8_t>(selects ? 1 : 0));
    }
    template <class Number>
    void add(Number value) {
        const auto bits = static_cast<std::uint64_t>(value);
        for (std::size_t i = 0; i < sizeof(Number); ++i)
            bytes_.push_back(static_cast<char>(bits >> (8 * i) & 255U));
    }
    void add(const std::string& text) { bytes_.append(text.c_str(), text.size() + 1); }
    void reserve(std::size_t more) { bytes_.reserve(bytes_.size() + more); }
    void add_values(std::span<const float> values) {
        const std::size_t end = bytes_.size();
        bytes_.resize(end + values.size_bytes());
        std::memcpy(&bytes_[end], values.data(), values.size_bytes());
    }
    std::string finish() && {
        for (std::size_t i = 0; i < 4; ++i)
            bytes_[i] = static_cast<char>(bytes_.size() >> (8 * i) & 255U);
        return std::move(bytes_);
    }

private:
    std::string bytes_;
};

}  // namespace

std::string create_packet(const std::string& name, const Picture& picture, bool selects) {
    Packet packet(PacketKind::create_image, selects);
    packet.add(name);
    packet.add(static_cast<std::int32_t>(picture.width));
    packet.add(static_cast<std::int32_t>(picture.height));
    packet.add(static_cast<std::int32_t>(picture.channels.size()));
    for (const Channel& channel : picture.channels) packet.add(channel.name);
    return std::move(packet).finish();
}

std::vector<DisplayBlock> blocks_of(const Picture& picture) {
    std::vector<DisplayBlock> blocks;
    for (std::size_t c = 0; c < picture.channels.size(); c += kBlockChannels)
        for (int y = 0; y < picture.height; y += kBlockPixels)
            for (int x = 0; x < picture.width; x += kBlockPixels)
                blocks.push_back(
                    {.x = x,
                     .y = y,
                     .width = std::min(kBlockPixels, picture.width - x),
                     .height = std::min(kBlockPixels, picture.height - y),
                     .first_channel = c,
                     .channels = std::min(kBlockChannels, picture.channels.size() - c)});
    return blocks;
}

std::string update_packet(const std::string& name, const Picture& picture,
                          const DisplayBlock& block) {
    const std::span channels =
        std::span(picture.channels).subspan(block.first_channel, block.channels);
    Packet packet(PacketKind::update_image_of_strides, false);
    packet.add(name);
    packet.add(static_cast<std::int32_t>(channels.size()));
    for (const Channel& channel : channels) packet.add(channel.name);
    for (const int number : {block.x, block.y, block.width, block.height})
        packet.add(static_cast<std::int32_t>(number));
    const auto width = static_cast<std::size_t>(block.width);
    const std::size_t pixels = width * static_cast<std::size_t>(block.height);
    for (std::size_t c = 0; c < channels.size(); ++c)  // where its values begin, in floats
        packet.add(static_cast<std::int64_t>(c * pixels));
    for (std::size_t c = 0; c < channels.size(); ++c)  // from one value of it to the next
        packet.add(std::int64_t{1});
    packet.reserve(sizeof(float) * pixels * channels.size());
    for (const Channel& channel : channels)
        for (int row = 0; row < block.height; ++row) {
            const auto line = static_cast<std::size_t>(block.y + row);
            const std::size_t first =
                line * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(block.x);
            packet.add_values(std::span(channel.values).subspan(first, width));
        }
    return std::move(packet).finish();
}

}  // namespace sunfleck::engine
