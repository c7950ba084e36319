// Blocks by which a picture is judged.
#include "planning/judged_blocks.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(JudgedBlocks, cover_each_pixel_once) {
    const PixelWindow window{3, 5, 23, 16};  // 20 x 11
    const BlockGrid blocks = judged_blocks(window);
    EXPECT_EQ(blocks.count(), 6U);
    EXPECT_EQ(blocks.block(0).pixels(), 64U);
    EXPECT_EQ(blocks.block(2).pixels(), 4U * 8U);
    EXPECT_EQ(blocks.block(5).pixels(), 4U * 3U);
    EXPECT_EQ(blocks.block_of(0), 0U);
    EXPECT_EQ(blocks.block_of(19), 2U);
    EXPECT_EQ(blocks.block_of(20 * 8), 3U);
    const std::vector<double> sums = block_sums(blocks, PixelValues(window.pixels(), 0.5));
    EXPECT_EQ(sums[5], 6);
    EXPECT_EQ(judged_blocks(window, 2).block(0).pixels(), 11U * 16U);
}

TEST(JudgedBlocks, give_all_of_their_pixels_one_scale) {
    const PixelWindow window{0, 0, 16, 8};
    PixelValues light(window.pixels(), 1);
    light[3] = 65;  // the first block's brightness is two, the picture's 1.5
    const PixelValues relative = squared_scales(window, light, Objective::relative);
    EXPECT_DOUBLE_EQ(relative[3], 4 + 0.01 * 2.25);
    EXPECT_DOUBLE_EQ(relative[16 * 7 + 7], relative[3]);
    EXPECT_DOUBLE_EQ(relative[8], 1 + 0.01 * 2.25);
    EXPECT_EQ(squared_scales(window, light, Objective::absolute),
              PixelValues(window.pixels(), 2.25));
}

}  // namespace
}  // namespace sunfleck::engine
