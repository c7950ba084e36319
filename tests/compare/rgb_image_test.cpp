// Pictures of every format as linear RGB.
#include "compare/rgb_image.h"

#include "image/picture_file.h"
#include "image/temporary_folder.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <fstream>

namespace sunfleck::engine {
namespace {

using RgbImages = testing_support::TemporaryFolder;

Picture two_pixels() {
    Picture picture{2, 1, {}, {}};
    for (const char* name : {"R", "G", "B", "error.Y"}) picture.add(name);
    picture.channels[0].values = {0.25F, 100};
    picture.channels[1].values = {0.5F, -1};
    picture.channels[2].values = {1, INFINITY};
    return picture;
}

TEST_F(RgbImages, exr_keeps_its_values) {
    write_picture(path("x.exr"), two_pixels());
    const RgbImage image = read_rgb(path("x.exr"));
    ASSERT_EQ(image.pixels.size(), 2U);
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.pixels[0], Vec3(0.25F, 0.5F, 1));
    EXPECT_EQ(image.pixels[1].x, 100);
    EXPECT_EQ(broken_pixels(image), 1U);
}

TEST_F(RgbImages, png_becomes_linear_light) {
    write_picture(path("x.png"), two_pixels());
    const RgbImage image = read_rgb(path("x.png"));
    EXPECT_NEAR(image.pixels[0].x, 0.25, 0.004);
    EXPECT_NEAR(image.pixels[0].z, 1, 1e-6);
}

TEST_F(RgbImages, grey_counts_as_three_and_rows_are_from_the_top) {
    const auto rows = std::bit_cast<std::array<char, 8>>(std::array{1.0F, 2.0F});
    std::ofstream file(path("x.pfm"), std::ios::binary);
    file << "Pf\n1 2\n-1.0\n";
    file.write(rows.data(), rows.size());  // a PFM's rows are from the bottom
    file.close();
    const RgbImage image = read_rgb(path("x.pfm"));
    EXPECT_EQ(image.pixels[0], Vec3(2));
    EXPECT_EQ(image.pixels[1], Vec3(1));
}

TEST_F(RgbImages, what_is_no_picture_is_refused) {
    EXPECT_THROW(read_rgb(path("missing.exr")), Error);
    std::ofstream(path("x.exr")) << "no picture";
    EXPECT_THROW(read_rgb(path("x.exr")), Error);
}

}  // namespace
}  // namespace sunfleck::engine
