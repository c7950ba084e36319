// The sRGB curve: known values, inverse of each other, every level reached.
#include "image/srgb.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Srgb, known_values) {
    EXPECT_NEAR(srgb_decode(0.5F), 0.2140411F, 1e-6F);
    EXPECT_NEAR(srgb_encode(0.2140411F), 0.5F, 1e-6F);
    EXPECT_NEAR(srgb_encode(0.18F), 0.4613561F, 1e-6F);
    EXPECT_NEAR(srgb_encode(0.001F), 0.01292F, 1e-7F);
}

TEST(Srgb, every_level_survives_decoding_and_encoding) {
    for (int level = 0; level < 256; ++level)
        EXPECT_EQ(srgb_byte(srgb_decode(static_cast<float>(level) / 255)), level);
}

}  // namespace
}  // namespace sunfleck::engine
