// PNG files: the sRGB levels of known light, exposure, and damage that ends in an Error.
#include "image/png.h"

#include "image/read_file.h"
#include "sunfleck/error.h"
#include "temporary_folder.h"

#include <png.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace sunfleck::engine {
namespace {

using Png = testing_support::TemporaryFolder;

Picture grey(const std::vector<float>& light) {
    Picture picture{static_cast<int>(light.size()), 1, {}, {}};
    for (const char* name : {"R", "G", "B"}) picture.add(name).values = light;
    return picture;
}

std::vector<std::uint16_t> levels(const PngImage& image, int channel) {
    std::vector<std::uint16_t> result;
    for (std::size_t i = 0; i < image.values.size(); i += static_cast<std::size_t>(image.channels))
        result.push_back(image.values[i + static_cast<std::size_t>(channel)]);
    return result;
}

TEST_F(Png, light_becomes_the_levels_of_srgb) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    // 0.2140 is the light of level 127.5 (IEC 61966-2-1), 0.0031308 the end of the straight part.
    write_png(path("a.png"),
              grey({0, 1, 0.18F, 0.5F, 0.0031308F, 0.215F, 0.213F, -1, 2, nan, infinity, 1e-5F}));
    const PngImage image = read_png(path("a.png"));
    EXPECT_EQ(image.width, 12);
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.bits, 8);
    EXPECT_EQ(levels(image, 0),
              (std::vector<std::uint16_t>{0, 255, 118, 188, 10, 128, 127, 0, 255, 0, 255, 0}));
}

TEST_F(Png, exposure_is_in_stops) {
    write_png(path("a.png"), grey({0.25F}), {.exposure = 2});
    write_png(path("b.png"), grey({1.0F}), {.exposure = -1});
    EXPECT_EQ(read_png(path("a.png")).values[0], 255);
    EXPECT_EQ(read_png(path("b.png")).values[0], 188);
}

/// Of 16 bits each level is a 65535th, not a level of 8 bits twice.
TEST_F(Png, sixteen_bits_are_levels_of_srgb_too) {
    write_png(path("a.png"), grey({0, 1, 0.18F, 1e-5F, 2}), {}, 16);
    const PngImage image = read_png(path("a.png"));
    EXPECT_EQ(image.bits, 16);
    EXPECT_EQ(levels(image, 1), (std::vector<std::uint16_t>{0, 65535, 30235, 8, 65535}));
    const std::string bytes = read_file(path("a.png"));
    EXPECT_NE(bytes.find("sRGB"), std::string::npos) << "it says its colour space";
}

TEST_F(Png, pixels_and_channels_stay_in_place) {
    Picture picture{3, 2, {}, {}};
    picture.add("R").values = {0, 1, 0, 0, 0, 0};
    picture.add("G").values = {0, 0, 0, 0, 0, 1};
    picture.add("B").values = {1, 0, 0, 0, 0, 0};
    write_png(path("a.png"), picture);
    const PngImage image = read_png(path("a.png"));
    EXPECT_EQ(image.at(1, 0, 0), 1);
    EXPECT_EQ(image.at(2, 1, 1), 1);
    EXPECT_EQ(image.at(0, 0, 2), 1);
    EXPECT_EQ(image.at(0, 1, 2), 0);
}

/// Writes a PNG of another kind by the library's simple interface.
void write_other(const std::string& path, png_uint_32 format, const void* values) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = 2;
    image.height = 1;
    image.format = format;
    ASSERT_NE(png_image_write_to_file(&image, path.c_str(), 0, values, 0, nullptr), 0);
}

TEST_F(Png, other_kinds_keep_their_values) {
    const std::array<std::uint8_t, 4> grey_alpha = {10, 255, 30, 40};
    write_other(path("ga.png"), PNG_FORMAT_GA, grey_alpha.data());
    EXPECT_EQ(read_png(path("ga.png")).values, (std::vector<std::uint16_t>{10, 255, 30, 40}));
    EXPECT_EQ(read_png(path("ga.png")).channels, 2);
    const std::array<std::uint16_t, 2> deep = {0x1234, 0xFFFF};
    write_other(path("16.png"), PNG_FORMAT_LINEAR_Y, deep.data());
    const PngImage image = read_png(path("16.png"));
    EXPECT_EQ(image.bits, 16);
    EXPECT_EQ(image.values, (std::vector<std::uint16_t>{0x1234, 0xFFFF}));
    EXPECT_EQ(image.at(1, 0, 0), 1);
}

TEST_F(Png, cut_or_changed_files_are_errors) {
    Picture picture{20, 20, {}, {}};
    for (const char* name : {"R", "G", "B"})
        for (std::size_t i = 0; float& value : picture.add(name).values)
            value = static_cast<float>(i++ % 17) / 17;
    write_png(path("a.png"), picture);
    const std::string bytes = read_file(path("a.png"));
    const auto fails = [&](const std::string& broken) {
        std::ofstream(path("b.png"), std::ios::binary | std::ios::trunc) << broken;
        try {
            read_png(path("b.png"));
        } catch (const Error&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(fails(bytes));
    for (std::size_t size = 0; size + 1 < bytes.size(); size += 5)
        EXPECT_TRUE(fails(bytes.substr(0, size))) << size;
    for (std::size_t i = 16; i < 33; ++i) {  // the header with its checksum
        std::string broken = bytes;
        broken[i] = static_cast<char>(broken[i] ^ 0x10);
        EXPECT_TRUE(fails(broken)) << i;
    }
    EXPECT_THROW(read_png(path("none.png")), Error);
}

TEST_F(Png, a_picture_without_rgb_is_refused) {
    Picture picture{1, 1, {}, {}};
    picture.add("Y");
    EXPECT_THROW(write_png(path("a.png"), picture), Error);
    EXPECT_EQ(files(), 0);
}

TEST(PngBytes, hold_values_of_all_channels_as_they_are) {
    const std::vector<std::uint8_t> values = {0, 1, 2, 127, 128, 200, 254, 255, 9, 10, 11, 12};
    for (const int channels : {1, 3, 4}) {
        const int width = 12 / channels / (channels == 1 ? 2 : 1);
        const std::string bytes = png_bytes({width, 12 / channels / width}, channels, values);
        const PngImage image = parse_png(bytes, "a.png");
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.channels, channels);
        EXPECT_EQ(image.bits, 8);
        EXPECT_TRUE(std::equal(values.begin(), values.end(), image.values.begin()));
    }
}

}  // namespace
}  // namespace sunfleck::engine
