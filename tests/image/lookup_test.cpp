// Lookups between texels and beyond the edges, against values worked out by hand.
#include "image/lookup.h"

#include <gtest/gtest.h>

#include <limits>

namespace sunfleck::engine {
namespace {

/// Texel (x, y) of 4 x 2 is x + 10 y.
Image numbered() {
    return {{4, 2}, 1, std::vector<float>{0, 1, 2, 3, 10, 11, 12, 13}};
}

float at(float s, float t, const Wraps& wraps) {
    return bilinear(numbered(), {s, t}, wraps)[0];
}

float near(float s, float t, Wrap wrap) {
    return nearest(numbered(), {s, t}, wrap)[0];
}

TEST(Lookup, is_linear_between_the_centres) {
    EXPECT_FLOAT_EQ(at(0.125F, 0.25F, Wrap::clamp), 0);
    EXPECT_FLOAT_EQ(at(0.375F, 0.25F, Wrap::clamp), 1);
    EXPECT_FLOAT_EQ(at(0.3F, 0.25F, Wrap::clamp), 0.7F);
    EXPECT_FLOAT_EQ(at(0.3F, 0.5F, Wrap::clamp), 5.7F);
    EXPECT_FLOAT_EQ(at(0.875F, 0.75F, Wrap::clamp), 13);
}

TEST(Lookup, beyond_the_edges_is_what_the_wrap_says) {
    EXPECT_FLOAT_EQ(at(0, 0.25F, Wrap::clamp), 0);
    EXPECT_FLOAT_EQ(at(0, 0.25F, Wrap::repeat), 1.5F);
    EXPECT_FLOAT_EQ(at(-7, 3.25F, Wrap::repeat), 1.5F);
    EXPECT_FLOAT_EQ(at(0, 0.25F, Wrap::mirror), 0);
    EXPECT_FLOAT_EQ(at(1.125F, 0.25F, Wrap::mirror), 3);
    EXPECT_FLOAT_EQ(at(-0.375F, 0.25F, Wrap::mirror), 1);
    EXPECT_FLOAT_EQ(at(1.125F, 1.25F, {Wrap::clamp, Wrap::repeat}), 3);
    EXPECT_FLOAT_EQ(at(1, 0.75F, Wrap::black), 6.5F);
    EXPECT_FLOAT_EQ(at(1.2F, 0.75F, Wrap::black), 0);
    EXPECT_FLOAT_EQ(at(5, -5, Wrap::clamp), 3);
    EXPECT_FLOAT_EQ(near(-0.01F, 0.25F, Wrap::repeat), 3);
    EXPECT_FLOAT_EQ(near(-0.01F, 0.25F, Wrap::black), 0);
    EXPECT_FLOAT_EQ(near(0.99F, 0.51F, Wrap::clamp), 13);
}

TEST(Lookup, octahedral_edges_meet_their_other_half) {
    // Beyond the left edge of a row is the left edge of the mirrored row.
    EXPECT_FLOAT_EQ(near(-0.1F, 0.25F, Wrap::octahedral_sphere), 10);
    EXPECT_FLOAT_EQ(near(1.1F, 0.75F, Wrap::octahedral_sphere), 3);
    EXPECT_FLOAT_EQ(near(0.1F, -0.1F, Wrap::octahedral_sphere), 3);
    EXPECT_FLOAT_EQ(near(0.9F, 1.1F, Wrap::octahedral_sphere), 10);
    EXPECT_FLOAT_EQ(at(0, 0.25F, Wrap::octahedral_sphere), 5);
}

TEST(Lookup, of_numbers_that_are_none_gives_a_texel) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::octahedral_sphere})
        for (const float odd :
             {nan, 1e30F, -1e30F, 1e8F, -1e8F, std::numeric_limits<float>::infinity()}) {
            const float value = at(odd, odd, wrap);
            EXPECT_TRUE(value >= 0 && value <= 13) << value;
        }
}

TEST(Lookup, of_one_texel_is_that_texel) {
    const Image one({1, 1}, 3, std::vector<std::uint8_t>{51, 102, 255},
                    {Encoding::Kind::linear, 1});
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::octahedral_sphere}) {
        const auto value = bilinear(one, {0.9F, 0.2F}, wrap);
        EXPECT_FLOAT_EQ(value[0], 0.2F);
        EXPECT_FLOAT_EQ(value[1], 0.4F);
        EXPECT_FLOAT_EQ(value[2], 1);
        EXPECT_EQ(value[3], 0);
    }
}

}  // namespace
}  // namespace sunfleck::engine
