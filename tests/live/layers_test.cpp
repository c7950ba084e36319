// Layers of a picture, and their numbers of 16 bits.
#include "live/layers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sunfleck::engine {
namespace {

Picture picture_of(const std::vector<const char*>& channels) {
    Picture picture{1, 1, {}, {}};
    for (const char* name : channels) picture.add(name);
    return picture;
}

TEST(LiveLayers, leave_ids_out) {
    Picture picture = picture_of({"R", "G", "B", "CryptoObject00.R", "CryptoObject00.G"});
    EXPECT_EQ(layers_of(picture).size(), 2U) << "so far it is a name as any other";
    picture.metadata["cryptomatte/0123456/name"] = "CryptoObject";
    EXPECT_EQ(layers_of(picture).size(), 1U);
}

/// As other programs write them: by the alphabet, with transparency, some apart.
TEST(LiveLayers, have_their_channels_in_the_order_of_colours) {
    const Picture picture =
        picture_of({"A", "B", "G", "R", "direct.B", "direct.G", "depth.Z", "direct.R", "ids"});
    const std::vector<LiveLayer> layers = layers_of(picture);
    ASSERT_EQ(layers.size(), 3U);
    const auto text = [](const LiveLayer& layer) {
        std::string names = layer.name + ":";
        for (const Channel* channel : layer.channels) names += " " + channel->name;
        return names;
    };
    EXPECT_EQ(text(layers[0]), "picture: R G B");
    EXPECT_EQ(text(layers[1]), "direct: direct.R direct.G direct.B");
    EXPECT_EQ(text(layers[2]), "depth: depth.Z");
}

/// The value that a page reads.
float read_back(float value) {
    Picture picture = picture_of({"Y"});
    picture.channels[0].values[0] = value;
    const std::string bytes = layer_bytes(layers_of(picture).front());
    EXPECT_EQ(bytes.size(), 2U);
    const auto low = static_cast<std::uint8_t>(bytes[0]);
    const auto high = static_cast<std::uint8_t>(bytes[1]);
    return std::bit_cast<float>(std::uint32_t{high} << 24U | std::uint32_t{low} << 16U);
}

TEST(LiveLayers, keep_suns_and_shadows) {
    for (const float value : {1e-30F, 0.3F, 1.0F, 70'000.0F, 3e9F, -0.25F, 0.0F})
        EXPECT_NEAR(read_back(value), value, std::abs(value) / 256);
    const float infinite = std::numeric_limits<float>::infinity();
    EXPECT_EQ(read_back(infinite), infinite);
    // Halfway between two: to the even one, down and up.
    EXPECT_EQ(read_back(1 + 1.0F / 256), 1);
    EXPECT_EQ(read_back(1 + 3.0F / 256), 1 + 4.0F / 256);
}

}  // namespace
}  // namespace sunfleck::engine
