// Packets for tev, against its description.
#include "display/packets.h"

#include "display/receiver.h"

namespace sunfleck::engine {
namespace {

using testing_support::Images;
using testing_support::read_images;

/// Channels of numbers that are all different.
Picture numbered(int width, int height, const std::vector<std::string>& names) {
    Picture picture{width, height, {}, {}};
    float next = 0.25F;
    for (const std::string& name : names)
        for (float& value : picture.add(name).values) value = next++;
    return picture;
}

std::string bytes_of(const std::vector<int>& bytes) {
    return {bytes.begin(), bytes.end()};
}

/// As the description has it, written by hand.
TEST(DisplayPackets, have_these_bytes) {
    const Picture picture = numbered(2, 1, {"R", "d.Z"});
    EXPECT_EQ(create_packet("n", picture, true),
              bytes_of({26, 0, 0, 0, 4, 1, 'n', 0,   2, 0,   0,   0,   1,
                        0,  0, 0, 2, 0, 0, 0,   'R', 0, 'd', '.', 'Z', 0}));
    EXPECT_EQ(
        update_packet("n", picture, {.width = 2, .height = 1, .channels = 2}),
        bytes_of({82, 0, 0,   0,  6, 0, 'n', 0,  2, 0, 0,  0,  'R', 0, 'd', '.', 'Z', 0,  // names
                  0,  0, 0,   0,  0, 0, 0,   0,  2, 0, 0,  0,  1,   0, 0,   0,            // block
                  0,  0, 0,   0,  0, 0, 0,   0,  2, 0, 0,  0,  0,   0, 0,   0,            // offsets
                  1,  0, 0,   0,  0, 0, 0,   0,  1, 0, 0,  0,  0,   0, 0,   0,            // strides
                  0,  0, 128, 62, 0, 0, 160, 63, 0, 0, 16, 64, 0,   0, 80,  64}));        // floats
}

TEST(DisplayPackets, cover_each_pixel_of_each_channel_once_and_the_picture_first) {
    const Picture picture =
        numbered(300, 130, {"R", "G", "B", "direct.R", "direct.G", "direct.B", "error.Y"});
    std::string bytes = create_packet("x", picture, false);
    std::size_t values = 0;
    for (const DisplayBlock& block : blocks_of(picture)) {
        bytes += update_packet("x", picture, block);
        values += static_cast<std::size_t>(block.width * block.height) * block.channels;
    }
    EXPECT_EQ(values, 7 * picture.pixels());
    const Images images = read_images(bytes);
    EXPECT_EQ(images.by_name.at("x"), picture);
    EXPECT_EQ(images.left, 0U);
    EXPECT_LT(images.longest_packet, 128U * 128 * 12 + 128);
    for (std::size_t i = 0; i < images.updated.size(); ++i)
        EXPECT_EQ(images.updated[i] == "R", i < 6) << i;
}

}  // namespace
}  // namespace sunfleck::engine
