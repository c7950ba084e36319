// Pictures as other programs write them: inks, other channels, numbers that are none, other
// formats.
#include "image/read_image.h"
#include "image_files.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <limits>

namespace sunfleck::engine {
namespace {

using namespace testing_support;

Image mended(Image image) {
    image.mend_broken();
    return image;
}

std::string refusal_of(const std::string& bytes, const std::string& name) {
    try {
        parse_image(bytes, name);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

void expect_refusal(const std::string& bytes, const std::string& name, const std::string& part) {
    EXPECT_NE(refusal_of(bytes, name).find(part), std::string::npos) << refusal_of(bytes, name);
}

void expect_colour(const Image& image, const Vec3& bytes, const std::string& what) {
    for (int c = 0; c < 3; ++c) {
        const float wanted = Encoding{}.decode(bytes[c] / 255);
        EXPECT_NEAR(image.rgb(3, 3)[c], wanted, 0.02F) << what << ", channel " << c;
    }
}

/// A sheet of 8 x 8 texels of one mixture of inks.
Bytes sheet(const Bytes& inks) {
    Bytes all;
    for (int i = 0; i < 64; ++i) all.insert(all.end(), inks.begin(), inks.end());
    return all;
}

TEST(Image, jpeg_of_four_inks_is_read) {
    // As Adobe's programs store them, 255 is no ink: 200 * 128 / 255, and so on.
    const Bytes inverted = sheet({200, 100, 50, 128});
    for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
        const Image image = parse_image(jpeg_file({8, 8}, 4, inverted, 100, stored), "a.jpg");
        EXPECT_EQ(image.channels(), 3);
        expect_colour(image, {100.4F, 50.2F, 25.1F}, stored == JCS_CMYK ? "CMYK" : "YCCK");
    }
    const Image plain = parse_image(
        jpeg_file({8, 8}, 4, sheet({55, 155, 205, 127}), 100, JCS_CMYK, false), "a.jpg");
    expect_colour(plain, {100.4F, 50.2F, 25.1F}, "CMYK without a marker");
}

using ChannelValues = std::vector<std::vector<float>>;

Image exr_of(const std::vector<std::string>& names, const ChannelValues& values) {
    return parse_image(exr_file<float>({1, 1}, names, values), "a.exr");
}

TEST(Image, exr_of_cie_xyz_becomes_srgb) {
    // The white of sRGB, and its red: IEC 61966-2-1.
    const Image white = exr_of({"X", "Y", "Z"}, {{0.9505F}, {1}, {1.0890F}});
    const Image red = exr_of({"X", "Y", "Z"}, {{0.4124F}, {0.2126F}, {0.0193F}});
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(white.rgb(0, 0)[c], 1, 1e-3F);
        EXPECT_NEAR(red.rgb(0, 0)[c], c == 0 ? 1 : 0, 1e-3F);
    }
    EXPECT_NE(white.remark().find("XYZ"), std::string::npos);
}

TEST(Image, exr_colours_may_be_named_otherwise) {
    const std::vector<std::vector<std::string>> namings = {
        {"r", "g", "b"},
        {"red", "green", "blue"},
        {"Beauty.R", "Beauty.G", "Beauty.B"},
        {"ViewLayer.Combined.r", "ViewLayer.Combined.g", "ViewLayer.Combined.b"}};
    for (const auto& names : namings) {
        const Image image = exr_of(names, {{1}, {2}, {3}});
        EXPECT_EQ(image.rgb(0, 0), Vec3(1, 2, 3)) << names[0];
        EXPECT_NE(image.remark().find(names[0]), std::string::npos) << image.remark();
    }
    EXPECT_EQ(exr_of({"L.R", "L.G", "L.B", "depth.Z"}, {{1}, {2}, {3}, {9}}).rgb(0, 0),
              Vec3(1, 2, 3));
    EXPECT_EQ(exr_of({"R", "G", "B"}, {{1}, {2}, {3}}).remark(), "");
    EXPECT_EQ(exr_of({"L.r", "L.g", "L.b", "L.a"}, {{1}, {2}, {3}, {.5F}}).channels(), 4);
}

TEST(Image, exr_without_colours_is_refused_by_name) {
    const auto refused = [](const std::vector<std::string>& names, const std::string& part) {
        const ChannelValues values(names.size(), std::vector<float>(1, 1));
        expect_refusal(exr_file<float>({1, 1}, names, values), "a.exr", part);
    };
    refused({"N.X", "N.Y", "N.Z"}, "N.X, N.Y, N.Z");
    refused({"R", "G"}, "G, R");
    refused({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}, "2 layers of colours");
    refused({"Y", "RY", "BY"}, "luminance and chroma");
}

TEST(Image, texels_that_are_no_numbers_are_counted_and_mended) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInf = std::numeric_limits<float>::infinity();
    const std::string file =
        exr_file<float>({3, 2}, {"R", "G", "B"},
                        {{0, 1, 2, 3, kInf, 5}, {0, 1, 2, 3, kNan, 5}, {0, 1, 2, 3, 4, -kInf}});
    EXPECT_EQ(parse_image(file, "a.exr").broken().count, 0U);  // as they stand in the file
    const Image image = mended(parse_image(file, "a.exr"));
    EXPECT_EQ(image.broken().count, 2U);
    EXPECT_EQ(image.broken().first, Vec2i(1, 1));
    EXPECT_EQ(image.rgb(1, 1), Vec3(65504, 0, 4));
    EXPECT_EQ(image.rgb(2, 1), Vec3(5, 5, 0));
    EXPECT_EQ(image.rgb(0, 1), Vec3(3, 3, 3));
    const Image pfm = mended(parse_image(pfm_file("Pf\n2 1\n-1\n", {kNan, 1}, true), "a.pfm"));
    EXPECT_EQ(pfm.broken().count, 1U);
    const half broken = half(kInf);
    const Image halves = mended(parse_image(exr_file<half>({1, 1}, {"Y"}, {{broken}}), "a.exr"));
    EXPECT_EQ(halves.rgb(0, 0).x, 65504);
    const Image sound = mended(parse_image(pfm_file("Pf\n1 1\n-1\n", {1}, true), "a.pfm"));
    EXPECT_EQ(sound.broken().count, 0U);
}

TEST(Image, other_content_is_named) {
    expect_refusal("", "a.png", "is empty");
    expect_refusal("version https://git-lfs.github.com/spec/v1\n", "a.tga", "git lfs pull");
    expect_refusal("<html><body>", "a.jpg", "a web page");
    expect_refusal("II*" + std::string(1, '\0'), "a.exr", "a TIFF picture");
    expect_refusal("GIF89a", "a.png", "a GIF picture");
    expect_refusal("PK\x03\x04", "a.hdr", "a ZIP archive");
    expect_refusal("404: Not Found", "a.png", "it begins \"404: Not Found\"");
}

TEST(Image, that_claim_more_than_they_hold_are_refused_before_memory_is_asked_for) {
    const auto head = [](const std::string& text) { return text + "\n"; };
    expect_refusal("PF\n100000 100000\n-1\n" + std::string(100, 'x'), "a.pfm", "claims more");
    expect_refusal(head("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n") + "-Y 99999 +X 99999\n" +
                       std::string(100, 'x'),
                   "a.hdr", "claims more");
    std::string png = png_file({1, 1}, 8, PNG_COLOR_TYPE_RGB, {1, 2, 3});
    png[18] = png[22] = 1;  // 65537 x 65537; the checksum does not fit either
    EXPECT_NE(refusal_of(png, "a.png"), "");
    std::string jpeg = jpeg_file({8, 8}, 3, Bytes(192, 9));
    const std::size_t size = jpeg.find("\xFF\xC0") + 5;
    jpeg.replace(size, 4, "\xFF\xDC\xFF\xDC");
    expect_refusal(jpeg, "a.jpg", "claims more");
}

}  // namespace
}  // namespace sunfleck::engine
