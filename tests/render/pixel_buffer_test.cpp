// Pixels and their neighbours.
#include "planning/pixel_buffer.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Raster, smooths_by_binomial_weights_and_keeps_an_even_light) {
    const PixelWindow window{2, 1, 7, 5};  // 5 x 4
    EXPECT_EQ(smoothed(PixelValues(20, 3), window), PixelValues(20, 3));
    PixelValues spot(20, 0);
    spot[7] = 16;
    const PixelValues wide = smoothed(spot, window);
    EXPECT_EQ(wide[7], 4);
    EXPECT_EQ(wide[6], 2);
    EXPECT_EQ(wide[13], 1);
    EXPECT_EQ(wide[2], 16 * 2.0 / 12) << "at the edge";
    EXPECT_EQ(wide[9], 0);
    EXPECT_EQ(mean_value(spot), 0.8);
}

TEST(Raster, tells_of_all_what_one_pixel_of_each_cell_says) {
    const PixelCells cells{{0, 0, 5, 4}, 2};  // 3 x 2
    PixelValues pixels(20, 1e9);              // nobody asks
    for (int y = 0; y < cells.down(); ++y)
        for (int x = 0; x < cells.across(); ++x) pixels[cells.pixel_of(x, y)] = x;
    const PixelValues all = upsampled(pixels, cells);
    ASSERT_EQ(all.size(), 20U);
    EXPECT_EQ(all[0], 1 / 3.0);
    EXPECT_EQ(all[6], 1 / 3.0);
    EXPECT_EQ(all[2], 1);
    EXPECT_EQ(all[19], 2 - 1 / 3.0);
}

}  // namespace
}  // namespace sunfleck::engine
