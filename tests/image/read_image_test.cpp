// Images of every format: known texels come back, and damage ends in an Error of one line.
#include "image/read_image.h"

#include "core/random.h"
#include "image/srgb.h"
#include "image_files.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <map>

namespace sunfleck::engine {
namespace {

using namespace testing_support;
using Values = std::vector<float>;

constexpr Encoding kLinear{Encoding::Kind::linear, 1};

/// The channels of all texels, in order.
Values values_of(const Image& image) {
    Values values;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x)
            for (int c = 0; c < image.channels(); ++c)
                values.push_back(image.at(x, y).at(static_cast<std::size_t>(c)));
    return values;
}

std::string fault_of(const std::string& bytes, const std::string& name) {
    try {
        parse_image(bytes, name);
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return "";
}

void expect_near(const Values& seen, const Values& wanted, float tolerance) {
    ASSERT_EQ(seen.size(), wanted.size());
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_NEAR(seen[i], wanted[i], tolerance) << i;
}

TEST(ReadImage, png_of_8_bits_stays_so_and_is_decoded) {
    const std::string file = png_file({2, 1}, 8, PNG_COLOR_TYPE_RGB, {0, 64, 255, 10, 128, 200});
    const Image srgb = parse_image(file, "a.png");
    EXPECT_TRUE(std::holds_alternative<std::vector<std::uint8_t>>(srgb.texels()));
    EXPECT_EQ(srgb.channels(), 3);
    expect_near(values_of(srgb),
                {0, srgb_decode(64 / 255.0F), 1, srgb_decode(10 / 255.0F),
                 srgb_decode(128 / 255.0F), srgb_decode(200 / 255.0F)},
                1e-7F);
    expect_near(values_of(parse_image(file, "a.png", kLinear)),
                {0, 64 / 255.0F, 1, 10 / 255.0F, 128 / 255.0F, 200 / 255.0F}, 1e-7F);
    const Encoding gamma{Encoding::Kind::gamma, 2};
    EXPECT_NEAR(parse_image(file, "a.png", gamma).at(1, 0)[1], 128.0F * 128 / 255 / 255, 1e-6F);
}

TEST(ReadImage, png_of_16_bits_grey_alpha_and_palettes) {
    const Image deep = parse_image(
        png_file({2, 1}, 16, PNG_COLOR_TYPE_GRAY, {0x80, 0x01, 0xFF, 0xFF}), "a.png", kLinear);
    EXPECT_EQ(deep.channels(), 1);
    expect_near(values_of(deep), {32769 / 65535.0F, 1}, 1e-8F);
    const Image grey = parse_image(png_file({1, 2}, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {51, 7, 102, 9}),
                                   "a.png", kLinear);
    expect_near(values_of(grey), {0.2F, 0.4F}, 1e-7F);
    const Image holes = parse_image(
        png_file({2, 1}, 8, PNG_COLOR_TYPE_RGBA, {51, 0, 0, 255, 0, 102, 0, 0}), "a.png", kLinear);
    expect_near(values_of(holes), {0.2F, 0, 0, 1, 0, 0.4F, 0, 0}, 1e-7F);
    const Image whole =
        parse_image(png_file({1, 1}, 8, PNG_COLOR_TYPE_RGBA, {51, 0, 255, 255}), "a.png", kLinear);
    expect_near(values_of(whole), {0.2F, 0, 1}, 1e-7F);
    const Image indexed =
        parse_image(png_file({2, 1}, 8, PNG_COLOR_TYPE_PALETTE, {1, 0}, {{51, 0, 0}, {0, 0, 102}}),
                    "a.png", kLinear);
    expect_near(values_of(indexed), {0, 0, 0.4F, 0.2F, 0, 0}, 1e-7F);
}

TEST(ReadImage, jpeg_comes_back_nearly) {
    Bytes texels;
    Values wanted;
    for (int i = 0; i < 16 * 16; ++i)
        for (const int level : {60 + 8 * (i % 16), 128, 200 - 8 * (i / 16)}) {
            texels.push_back(static_cast<std::uint8_t>(level));
            wanted.push_back(srgb_decode(static_cast<float>(level) / 255));
        }
    const Image image = parse_image(jpeg_file({16, 16}, 3, texels, 100), "a.jpg", kLinear);
    EXPECT_EQ(image.channels(), 3);
    expect_near(values_of(image), wanted, 0.06F);  // chroma is halved: a few levels
    const Image grey = parse_image(jpeg_file({8, 8}, 1, Bytes(64, 200)), "a.jpg");
    EXPECT_EQ(grey.channels(), 1);
    expect_near(values_of(grey), Values(64, srgb_decode(200 / 255.0F)), 0.01F);
}

TEST(ReadImage, webp_with_and_without_alpha) {
    const Bytes rgb{10, 20, 30, 255, 0, 128};
    Values wanted;
    for (const std::uint8_t level : rgb)
        wanted.push_back(srgb_decode(static_cast<float>(level) / 255));
    const Image image = parse_image(webp_file({2, 1}, 3, rgb), "a.webp");
    EXPECT_EQ(image.channels(), 3);
    expect_near(values_of(image), wanted, 1e-6F);
    const Image holes = parse_image(webp_file({1, 2}, 4, {255, 0, 0, 255, 0, 255, 0, 51}), "");
    EXPECT_EQ(holes.channels(), 4);
    expect_near(values_of(holes), {1, 0, 0, 1, 0, 1, 0, srgb_decode(0.2F)}, 1e-6F);
}

TEST(ReadImage, tga_in_all_its_ways) {
    const auto decoded = [](const Bytes& levels) {
        Values values;
        for (const std::uint8_t level : levels)
            values.push_back(srgb_decode(static_cast<float>(level) / 255));
        return values;
    };
    const auto read = [](const std::string& file) { return values_of(parse_image(file, "a.TGA")); };
    const Bytes bgr = {3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10};
    const Bytes from_top = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    EXPECT_EQ(read(tga_file({2, 2}, 2, 24, 32, bgr)), decoded(from_top));
    EXPECT_EQ(read(tga_file({2, 2}, 2, 24, 0, bgr)),
              decoded({7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(read(tga_file({2, 2}, 2, 24, 48, bgr)),
              decoded({4, 5, 6, 1, 2, 3, 10, 11, 12, 7, 8, 9}));
    EXPECT_EQ(read(tga_file({3, 1}, 10, 32, 32, {129, 30, 20, 10, 99, 0, 3, 2, 1, 99})),
              decoded({10, 20, 30, 10, 20, 30, 1, 2, 3}));
    EXPECT_EQ(read(tga_file({4, 1}, 11, 8, 32, {130, 7, 0, 9})), decoded({7, 7, 7, 9}));
    EXPECT_EQ(read(tga_file({2, 1}, 1, 8, 32, {3, 2, 1, 6, 5, 4, 1, 0}, 2, 24)),
              decoded({4, 5, 6, 1, 2, 3}));
    EXPECT_EQ(read(tga_file({1, 1}, 2, 16, 32, {0x1F, 0x7C})), decoded({255, 0, 255}));
    EXPECT_NE(fault_of(tga_file({1, 1}, 1, 8, 32, {3, 2, 1, 5}, 1, 24), "a.tga"), "");
    EXPECT_NE(fault_of(tga_file({2, 2}, 2, 24, 32, bgr), "no_ending"), "");
}

TEST(ReadImage, hdr_plain_and_in_runs) {
    const Values wanted = {1, 0.5F, 0.25F, 0, 0, 0};
    expect_near(values_of(parse_image(hdr_file({2, 1}, {128, 64, 32, 129, 9, 9, 9, 0}), "a.hdr")),
                wanted, 0);
    expect_near(values_of(parse_image(hdr_file({3, 1}, {128, 64, 32, 129, 1, 1, 1, 2}), "a.hdr")),
                {1, 0.5F, 0.25F, 1, 0.5F, 0.25F, 1, 0.5F, 0.25F}, 0);
    // Of old: one texel, 43 more of it, and 256 more.
    const Image wide =
        parse_image(hdr_file({300, 1}, {128, 64, 32, 129, 1, 1, 1, 43, 1, 1, 1, 1}), "a.hdr");
    EXPECT_EQ(wide.rgb(299, 0), Vec3(1, 0.5F, 0.25F));
    // Runs of the four components: 8 of red 128; 4 of 64, then 4 plain; 8 of 32; 8 exponents.
    const Image runs = parse_image(
        hdr_file({8, 1}, {2, 2, 0, 8, 136, 128, 132, 64, 4, 1, 2, 3, 4, 136, 32, 136, 129}),
        "a.hdr");
    EXPECT_EQ(runs.rgb(0, 0), Vec3(1, 0.5F, 0.25F));
    EXPECT_EQ(runs.rgb(6, 0), Vec3(1, 3 / 128.0F, 0.25F));
    EXPECT_TRUE(std::holds_alternative<std::vector<float>>(runs.texels()));
}

/// Names of channels are any bytes; messages are one line, whatever these are.
TEST(ReadImage, names_of_channels_are_told_on_one_line) {
    const std::vector<std::vector<float>> values(3, std::vector<float>{1});
    const auto named = [&](const std::vector<std::string>& names) {
        return exr_file<float>({1, 1}, names, values);
    };
    const Image image = parse_image(named({"a\n.B", "a\n.G", "a\n.R"}), "a.exr");
    EXPECT_EQ(image.remark(), "its channels a?.R, a?.G, a?.B are its colours");
    std::string message;
    try {
        parse_image(named({"a\n", "b\x1B[1m", "c"}), "a.exr");
    } catch (const Error& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("a?, b?[1m, c"), std::string::npos) << message;
}

/// The texels begin behind the whole line end, not between its two bytes.
TEST(ReadImage, pfm_whose_lines_end_in_two_bytes) {
    const Image image = parse_image(pfm_file("Pf\r\n2 1\r\n-1\r\n", {1, 2}, true), "a.pfm");
    EXPECT_EQ(image.rgb(0, 0).x, 1);
    EXPECT_EQ(image.rgb(1, 0).x, 2);
    EXPECT_THROW(parse_image(pfm_file("PF4\n1 1\n-1\n", {1, 2, 3, 4}, true), "a.pfm"), Error);
}

TEST(ReadImage, pfm_of_both_byte_orders) {
    const std::vector<float> bottom_first = {1, 2, 3, 4, 5, 6};
    const Image big = parse_image(pfm_file("PF\n1 2\n2.0\n", bottom_first, false), "a.pfm");
    EXPECT_EQ(values_of(big), (Values{8, 10, 12, 2, 4, 6}));
    const Image small = parse_image(pfm_file("Pf 2 3 -1\n", bottom_first, true), "a.pfm");
    EXPECT_EQ(values_of(small), (Values{5, 6, 3, 4, 1, 2}));
}

TEST(ReadImage, exr_keeps_halves_and_takes_the_colours) {
    const std::vector<std::vector<half>> halves = {
        {half(1.5F), half(2)}, {half(3), half(4)}, {half(5), half(6)}, {half(0), half(1)}};
    const Image rgba = parse_image(exr_file<half>({2, 1}, {"R", "G", "B", "A"}, halves), "a.exr");
    EXPECT_TRUE(std::holds_alternative<std::vector<half>>(rgba.texels()));
    EXPECT_EQ(values_of(rgba), (Values{1.5F, 3, 5, 0, 2, 4, 6, 1}));
    const Image depth = parse_image(exr_file<float>({1, 2}, {"Z"}, {{0.1F, 7}}), "a.exr");
    EXPECT_EQ(values_of(depth), (Values{0.1F, 7}));
    const Image layers =
        parse_image(exr_file<float>({1, 1}, {"R", "x.R", "G", "B"}, {{1}, {9}, {2}, {3}}), "a.exr");
    EXPECT_EQ(values_of(layers), (Values{1, 2, 3}));
    const std::string fault = fault_of(exr_file<float>({1, 1}, {"u", "v"}, {{1}, {9}}), "a.exr");
    EXPECT_NE(fault.find("u, v"), std::string::npos) << fault;
}

/// One of each format, by name.
std::map<std::string, std::string> all_formats() {
    Bytes ramp;
    for (int i = 0; i < 24 * 8 * 3; ++i) ramp.push_back(static_cast<std::uint8_t>(i * 7));
    const std::vector<half> flat(24 * 8, half(0.5F));
    return {{"a.png", png_file({24, 8}, 8, PNG_COLOR_TYPE_RGB, ramp)},
            {"a.jpg", jpeg_file({24, 8}, 3, ramp)},
            {"a.tga", tga_file({24, 8}, 2, 24, 32, ramp)},
            {"b.tga", tga_file({3, 1}, 10, 32, 32, {129, 30, 20, 10, 99, 0, 3, 2, 1, 99})},
            {"a.hdr",
             hdr_file({8, 1}, {2, 2, 0, 8, 136, 128, 132, 64, 4, 1, 2, 3, 4, 136, 32, 136, 129})},
            {"a.pfm", pfm_file("PF\n2 1\n-1\n", {1, 2, 3, 4, 5, 6}, true)},
            {"a.webp", webp_file({24, 8}, 3, ramp)},
            {"a.exr", exr_file<half>({24, 8}, {"R", "G", "B"}, {flat, flat, flat})}};
}

TEST(ReadImage, cut_files_are_errors) {
    for (const auto& [name, file] : all_formats()) {
        EXPECT_EQ(fault_of(file, name), "");
        // The last bytes may hold no texel: end marks and check sums, a JPEG's last bits.
        const std::size_t texels_end = name == "a.png" || name == "a.jpg" ? 16 : 1;
        for (std::size_t size = 0; size + texels_end <= file.size(); size += 1 + file.size() / 90)
            EXPECT_NE(fault_of(file.substr(0, size), name), "") << name << " " << size;
    }
}

TEST(ReadImage, damaged_files_are_images_or_errors) {
    int images = 0;
    for (const auto& [name, file] : all_formats()) {
        RandomStream random(1, Purpose::test, static_cast<std::uint32_t>(name[0] + name[2]), 0);
        for (int trial = 0; trial < 200; ++trial) {
            std::string damaged = file;
            for (int change = 0; change <= trial % 3; ++change)
                damaged[random.next_fraction() % damaged.size()] =
                    static_cast<char>(random.next_fraction());
            if (fault_of(damaged, name).empty()) ++images;
        }
    }
    EXPECT_GT(images, 0);
}

TEST(ReadImage, small_files_that_claim_large_images_are_refused) {
    Bytes tiny(20, 1);
    for (const auto& [name, file] :
         std::map<std::string, std::string>{{"a.tga", tga_file({60000, 60000}, 2, 24, 0, tiny)},
                                            {"b.tga", tga_file({60000, 60000}, 10, 24, 0, tiny)},
                                            {"a.hdr", hdr_file({100000, 100000}, tiny)},
                                            {"b.hdr", hdr_file({0, 1}, tiny)},
                                            {"a.pfm", pfm_file("PF\n99999 99999\n1\n", {1}, true)},
                                            {"b.pfm", pfm_file("PF\n-1 1\n1\n", {1}, true)},
                                            {"a.txt", "some text"},
                                            {"none", ""}})
        EXPECT_NE(fault_of(file, name), "") << name;
    std::string jpeg = jpeg_file({8, 8}, 1, Bytes(64, 200));
    const std::size_t size = jpeg.find("\xFF\xC0") + 5;
    jpeg[size] = jpeg[size + 2] = '\xF0';
    EXPECT_NE(fault_of(jpeg, "a.jpg").find("more pixels"), std::string::npos);
}

/// 8 bits stay 8 bits; an alpha that is one everywhere is none.
TEST(ReadImage, grey_with_alpha_keeps_it_where_asked) {
    const Bytes texels = {51, 7, 102, 255};
    const Image holes = parse_image_with_alpha(
        png_file({1, 2}, 8, PNG_COLOR_TYPE_GRAY_ALPHA, texels), "a.png", kLinear);
    expect_near(values_of(holes), {0.2F, 0.2F, 0.2F, 7 / 255.0F, 0.4F, 0.4F, 0.4F, 1}, 1e-7F);
    const Image whole = parse_image_with_alpha(
        png_file({1, 1}, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {51, 255}), "a.png", kLinear);
    expect_near(values_of(whole), {0.2F, 0.2F, 0.2F}, 1e-7F);
}

}  // namespace
}  // namespace sunfleck::engine
