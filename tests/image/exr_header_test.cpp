// What an .exr says of itself: colour space, pixels, date; its layers in halves and in parts.
#include "core/random.h"
#include "image/exr.h"
#include "image/read_file.h"
#include "image/read_image.h"
#include "sunfleck/error.h"
#include "temporary_folder.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <cstdlib>

namespace sunfleck::engine {
namespace {

/// With a date of the environment, or without one.
class ExrHeader : public testing_support::TemporaryFolder {
protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        ::unsetenv("SOURCE_DATE_EPOCH");
    }
    void TearDown() override {
        ::unsetenv("SOURCE_DATE_EPOCH");
        TemporaryFolder::TearDown();
    }
};

/// Channels in the order of their names; the layers are picture, albedo and error.
Picture layered_picture(int width, int height) {
    Picture picture{width, height, {}, {{"seed", "3"}, {"software", "a test"}}};
    for (const char* name : {"B", "G", "R", "albedo.B", "albedo.G", "albedo.R", "error.Y"}) {
        RandomStream random(7, Purpose::test, static_cast<std::uint32_t>(name[0]), 0);
        for (float& value : picture.add(name).values) value = 4 * random.next_float();
    }
    return picture;
}

bool is_exact(ExrCompression compression) {
    return compression != ExrCompression::dwaa && compression != ExrCompression::dwab;
}

TEST_F(ExrHeader, says_its_colour_space_and_the_shape_of_its_pixels) {
    Picture picture = layered_picture(5, 4);
    picture.pixel_aspect = 1.5F;
    write_exr(path("a.exr"), picture);
    const Imf::MultiPartInputFile file(path("a.exr").c_str());
    const Imf::Header& header = file.header(0);
    ASSERT_TRUE(Imf::hasChromaticities(header));
    const Imf::Chromaticities& primaries = Imf::chromaticities(header);
    EXPECT_EQ(primaries.red, Imath::V2f(0.64F, 0.33F));
    EXPECT_EQ(primaries.blue, Imath::V2f(0.15F, 0.06F));
    EXPECT_EQ(primaries.white, Imath::V2f(0.3127F, 0.3290F));
    EXPECT_EQ(header.pixelAspectRatio(), 1.5F);
    EXPECT_FALSE(Imf::hasCapDate(header));
    EXPECT_EQ(read_exr(path("a.exr")), picture);
}

TEST_F(ExrHeader, has_the_date_of_the_environment_and_no_other) {
    const Picture picture = layered_picture(3, 2);
    const std::string without = exr_bytes(picture);
    EXPECT_EQ(exr_bytes(picture), without);
    ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
    const std::string dated = exr_bytes(picture);
    EXPECT_NE(dated, without);
    EXPECT_EQ(parse_exr(dated, "a.exr").metadata.at("capDate"), "2023:11:14 22:13:20");
    for (const char* bad : {"today", "-1", "12x", "253402300800"}) {
        ::setenv("SOURCE_DATE_EPOCH", bad, 1);
        EXPECT_THROW(check_exr_date(), Error) << bad;
        EXPECT_THROW(exr_bytes(picture), Error) << bad;
    }
}

TEST_F(ExrHeader, compresses_as_it_is_told) {
    const Picture picture = layered_picture(70, 50);
    const std::string zip = exr_bytes(picture);
    for (const auto& row : kExrCompressions) {
        const std::string bytes = exr_bytes(picture, {.compression = row.value});
        EXPECT_EQ(bytes == zip, row.value == ExrCompression::zip) << row.name;
        EXPECT_EQ(exr_bytes(picture, {.compression = row.value}), bytes) << row.name;
        const Picture back = parse_exr(bytes, "a.exr");
        EXPECT_EQ(back == picture, is_exact(row.value)) << row.name;
        for (std::size_t i = 0; i < picture.pixels(); ++i)
            EXPECT_NEAR(back.channels[1].values[i], picture.channels[1].values[i], 0.3) << row.name;
    }
}

TEST_F(ExrHeader, has_halves_in_the_layers_that_are_named) {
    const Picture picture = layered_picture(9, 7);
    for (const bool parts : {false, true}) {
        const Picture back =
            parse_exr(exr_bytes(picture, {.half_layers = {"albedo"}, .parts = parts}), "a.exr");
        for (const Channel& channel : picture.channels)
            EXPECT_EQ(back.find(channel.name)->values == channel.values,
                      !channel.name.starts_with("albedo"))
                << channel.name;
    }
}

TEST_F(ExrHeader, a_file_in_parts_reads_as_the_same_picture) {
    for (const auto& row : kExrCompressions) {
        Picture picture = layered_picture(37, 41);
        picture.pixel_aspect = 0.5F;
        write_exr(path("one.exr"), picture, {.compression = row.value});
        write_exr(path("parts.exr"), picture, {.compression = row.value, .parts = true});
        const Picture parts = read_exr(path("parts.exr"));
        const Picture one = read_exr(path("one.exr"));
        if (is_exact(row.value)) {
            EXPECT_EQ(parts, one) << row.name;
        }
        ASSERT_EQ(parts.channels.size(), one.channels.size());
        for (std::size_t c = 0; c < one.channels.size(); ++c) {
            EXPECT_EQ(parts.channels[c].name, one.channels[c].name);
            EXPECT_NEAR(parts.channels[c].values[99], one.channels[c].values[99], 0.3);
        }
    }
    const Picture halves = layered_picture(37, 41);
    EXPECT_EQ(parse_exr(exr_bytes(halves, {.half = true, .parts = true}), "a"),
              parse_exr(exr_bytes(halves, {.half = true}), "a"));
}

TEST_F(ExrHeader, parts_have_the_names_of_layers) {
    Picture picture = layered_picture(4, 3);
    std::rotate(picture.channels.begin(), picture.channels.begin() + 3, picture.channels.end());
    write_exr(path("a.exr"), picture, {.parts = true});
    const Imf::MultiPartInputFile file(path("a.exr").c_str());
    ASSERT_EQ(file.parts(), 3);
    EXPECT_EQ(file.header(0).name(), "albedo") << "the order of the channels";
    EXPECT_EQ(file.header(1).name(), "error");
    EXPECT_EQ(file.header(2).name(), "picture");
    EXPECT_EQ(file.header(1).type(), Imf::SCANLINEIMAGE);
    EXPECT_NE(file.header(2).channels().findChannel("R"), nullptr);
    for (int part = 0; part < 3; ++part)
        EXPECT_TRUE(Imf::hasChromaticities(file.header(part))) << part;
}

/// Writes a part of one row for each size, each with a channel R, as other programs do.
void write_foreign_parts(const std::string& path, const std::vector<int>& widths) {
    std::vector<Imf::Header> headers;
    for (const int width : widths) {
        headers.emplace_back(width, 1);
        headers.back().setName("part" + std::to_string(headers.size()));
        headers.back().setType(Imf::SCANLINEIMAGE);
        headers.back().displayWindow() = headers.front().displayWindow();
        headers.back().channels().insert("R", Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
    float light = 0;
    for (std::size_t i = 0; i < headers.size(); ++i) {
        std::vector<float> row(static_cast<std::size_t>(widths[i]), ++light);
        Imf::FrameBuffer buffer;
        buffer.insert("R", Imf::Slice::Make(Imf::FLOAT, row.data(), headers[i].dataWindow()));
        Imf::OutputPart part(file, static_cast<int>(i));
        part.setFrameBuffer(buffer);
        part.writePixels(1);
    }
}

TEST_F(ExrHeader, channels_that_several_parts_have_are_told_apart) {
    write_foreign_parts(path("a.exr"), {2, 2, 2});
    const Picture back = read_exr(path("a.exr"));
    ASSERT_EQ(back.channels.size(), 3U);
    EXPECT_EQ(back.find("R")->values, (std::vector<float>{1, 1}));
    EXPECT_EQ(back.find("part2.R")->values, (std::vector<float>{2, 2}));
    EXPECT_EQ(back.find("part3.R")->values, (std::vector<float>{3, 3}));
    EXPECT_FALSE(back.metadata.contains("name"));
}

TEST_F(ExrHeader, parts_of_several_sizes_are_refused) {
    write_foreign_parts(path("a.exr"), {2, 3});
    try {
        read_exr(path("a.exr"));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("has parts of several sizes"), std::string::npos);
    }
}

TEST_F(ExrHeader, cut_files_in_parts_are_errors) {
    const std::string bytes = exr_bytes(layered_picture(9, 40), {.parts = true});
    EXPECT_EQ(parse_exr(bytes, "a.exr").width, 9);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 60)
        EXPECT_THROW(parse_exr(bytes.substr(0, size), "a.exr"), Error) << size;
}

/// Readers of colours take the first part, which is the picture.
TEST_F(ExrHeader, a_file_in_parts_is_a_texture_too) {
    Picture picture = layered_picture(4, 3);
    const std::string bytes = exr_bytes(picture, {.parts = true});
    const Image image = parse_image(bytes, "a.exr");
    EXPECT_EQ(image.channels(), 3);
    EXPECT_EQ(image.at(1, 1)[0], picture.find("R")->values[5]);
}

}  // namespace
}  // namespace sunfleck::engine
