// Looks at pictures: luminance by blocks, values that none may hold, and the comparison.
#include "differential/look.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace sunfleck::engine::differential {
namespace {

Picture grey(int width, int height, float value) {
    Picture picture{width, height, {}, {}};
    for (const char* name : {"R", "G", "B"})
        for (float& one : picture.add(name).values) one = value;
    return picture;
}

TEST(Look, blocks_at_the_edge_are_means_of_what_they_have) {
    Picture picture = grey(12, 8, 2);
    for (Channel& channel : picture.channels)
        for (std::size_t i = 0; i < channel.values.size(); ++i)
            if (i % 12 >= 8) channel.values[i] = 5;
    const Look look = look_at(picture);
    ASSERT_EQ(look.blocks.size(), 2U);
    EXPECT_NEAR(look.blocks[0], 2, 1e-6);
    EXPECT_NEAR(look.blocks[1], 5, 1e-6);
    EXPECT_NEAR(look.mean, 3, 1e-6);
}

TEST(Look, not_a_number_infinite_and_negative_values_are_told_with_their_channel) {
    Picture picture = grey(4, 4, 1);
    EXPECT_FALSE(broken_values(picture, false));
    picture.channels[1].values[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(broken_values(picture, true)->find("G"), std::string::npos);
    picture.channels[1].values[3] = std::numeric_limits<float>::infinity();
    EXPECT_NE(broken_values(picture, true)->find("inf"), std::string::npos);
    picture.channels[1].values[3] = -1;
    EXPECT_TRUE(broken_values(picture, false));
    EXPECT_FALSE(broken_values(picture, true));
}

/// A colour outside of sRGB has a negative component, and a positive luminance.
TEST(Look, a_saturated_colour_is_no_negative_light) {
    Picture picture = grey(4, 4, 1);
    picture.channels[0].values[0] = -0.5F;
    EXPECT_FALSE(broken_values(picture, false));
}

/// Light of 420 nm, after adaptation from 8,000 to 6,500 kelvin.
TEST(Look, violet_light_under_another_white_is_no_negative_light) {
    Picture picture = grey(4, 4, 1);
    for (std::size_t c = 0; c < 3; ++c)
        picture.channels[c].values[0] = std::array{0.0035F, -0.0029F, 0.0177F}[c];
    EXPECT_FALSE(broken_values(picture, false));
    picture.channels[1].values[0] = -0.004F;
    EXPECT_TRUE(broken_values(picture, false));
}

/// Looks at renders of four blocks with 1% of noise. @param last  the last block's brightness.
std::vector<Look> four_looks(std::uint32_t stream, double last) {
    RandomStream random(3, Purpose::test, 0, stream);
    std::vector<Look> looks;
    for (int i = 0; i < 4; ++i) {
        Look look;
        for (const double value : {1.0, 2.0, 1.0, last})
            look.blocks.push_back(value * (1 + 0.02 * (random.next() - 0.5)));
        for (const double block : look.blocks) look.mean += block / 4;
        looks.push_back(look);
    }
    return looks;
}

TEST(Look, one_block_that_differs_is_found_and_named) {
    EXPECT_EQ(compare(four_looks(1, 3), four_looks(2, 3), {.allowance = {}}).verdict,
              Verdict::equal);
    const Comparison found =
        compare(four_looks(1, 2.4), four_looks(2, 3), {.mean = 0.2, .allowance = {}});
    EXPECT_EQ(found.verdict, Verdict::different);
    EXPECT_NE(found.text.find("block 3"), std::string::npos) << found.text;
}

TEST(Look, a_reported_bias_is_allowed_for) {
    const Bands bands{.mean = 0.2, .allowance = {0, {0, 0, 0, -0.6}}};
    EXPECT_EQ(compare(four_looks(1, 2.4), four_looks(2, 3), bands).verdict, Verdict::equal);
}

TEST(Look, pictures_of_nothing_are_equal) {
    const std::vector<Look> dark(4, look_at(grey(16, 16, 0)));
    EXPECT_EQ(compare(dark, dark, {.allowance = {}}).verdict, Verdict::equal);
}

}  // namespace
}  // namespace sunfleck::engine::differential
