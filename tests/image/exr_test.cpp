// EXR files: channels, texts and bits come back; damaged files are Errors.
#include "image/exr.h"

#include "core/random.h"
#include "image/read_file.h"
#include "image/read_image.h"
#include "sunfleck/error.h"
#include "temporary_folder.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

namespace sunfleck::engine {
namespace {

using Exr = testing_support::TemporaryFolder;

/// Channels in the order of their names, which is the order of the file.
Picture sample(int width, int height) {
    Picture picture{width, height, {}, {{"renderer", "sunfleck"}, {"settings", "a=1\nb=2"}}};
    for (const char* name : {"B", "G", "R", "direct.R", "error.Y"}) {
        RandomStream random(3, Purpose::test, static_cast<std::uint32_t>(name[0]), 0);
        for (float& value : picture.add(name).values)
            value = std::exp2(30 * random.next_float() - 15) * (random.next_float() - 0.2F);
    }
    return picture;
}

TEST_F(Exr, floats_come_back_bit_by_bit) {
    for (const auto& [width, height] : {std::pair{1, 1}, {37, 23}, {200, 3}}) {
        const Picture picture = sample(width, height);
        write_exr(path("a.exr"), picture);
        EXPECT_EQ(read_exr(path("a.exr")), picture);
    }
}

TEST_F(Exr, bytes_in_memory_are_those_of_the_file) {
    for (const bool half : {false, true}) {
        const Picture picture = sample(37, 23);
        write_exr(path("a.exr"), picture, {half});
        EXPECT_EQ(exr_bytes(picture, {half}), read_file(path("a.exr")));
    }
}

TEST_F(Exr, values_at_the_edge_come_back) {
    Picture picture{4, 1, {}, {}};
    const float infinity = std::numeric_limits<float>::infinity();
    picture.add("Y").values = {std::numeric_limits<float>::denorm_min(), infinity, -0.0F, 3e38F};
    write_exr(path("a.exr"), picture);
    EXPECT_EQ(read_exr(path("a.exr")).channels[0].values, picture.channels[0].values);
}

TEST_F(Exr, halves_have_three_digits_and_a_largest_value) {
    Picture picture{4, 1, {}, {}};
    picture.add("Y").values = {1.0F / 3, 1e9F, -1e9F, std::numeric_limits<float>::infinity()};
    write_exr(path("a.exr"), picture, {true});
    const std::vector<float> back = read_exr(path("a.exr")).channels[0].values;
    EXPECT_NEAR(back[0], 1.0F / 3, 1.0F / 3 / 2048);
    EXPECT_NE(back[0], 1.0F / 3);
    EXPECT_EQ(back[1], 65504);
    EXPECT_EQ(back[2], -65504);
    EXPECT_TRUE(std::isinf(back[3]));
}

TEST_F(Exr, the_same_picture_gives_the_same_bytes) {
    write_exr(path("a.exr"), sample(64, 40));
    write_exr(path("b.exr"), sample(64, 40));
    EXPECT_TRUE(read_file(path("a.exr")) == read_file(path("b.exr")));
}

TEST_F(Exr, rows_are_read_from_a_data_window_anywhere) {
    Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), Imath::Box2i({-3, 5}, {-2, 7}));
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    std::vector<float> values = {1, 2, 3, 4, 5, 6};
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
    {
        Imf::OutputFile file(path("w.exr").c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(3);
    }
    const Picture picture = read_exr(path("w.exr"));
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 3);
    EXPECT_EQ(picture.channels[0].values, values);
}

/// Rec. 2020's are not sRGB's; no primaries, and those of Rec. 709, are.
TEST_F(Exr, other_primaries_are_known) {
    const auto other = [&](const std::optional<Imf::Chromaticities>& primaries) {
        Imf::Header header(1, 1);
        std::array<half, 3> texel = {half(0.1F), half(0.8F), half(0.1F)};
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string name(1, "RGB"[c]);
            header.channels().insert(name, Imf::Channel(Imf::HALF));
            buffer.insert(name, Imf::Slice::Make(Imf::HALF, &texel.at(c), header.dataWindow()));
        }
        if (primaries) Imf::addChromaticities(header, *primaries);
        {
            Imf::OutputFile file(path("p.exr").c_str(), header);
            file.setFrameBuffer(buffer);
            file.writePixels(1);
        }
        return parse_image(read_file(path("p.exr")), "p.exr").has_other_primaries();
    };
    EXPECT_FALSE(other({}));
    EXPECT_FALSE(other(Imf::Chromaticities()));
    EXPECT_TRUE(other(Imf::Chromaticities({0.708F, 0.292F}, {0.17F, 0.797F}, {0.131F, 0.046F},
                                          {0.3127F, 0.329F})));
}

std::string fault_of(const std::string& path) {
    try {
        read_exr(path);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST_F(Exr, cut_files_are_errors) {
    write_exr(path("a.exr"), sample(9, 40));
    const std::string bytes = read_file(path("a.exr"));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 60) {
        std::ofstream(path("b.exr"), std::ios::binary | std::ios::trunc) << bytes.substr(0, size);
        EXPECT_NE(fault_of(path("b.exr")), "") << size;
    }
    EXPECT_NE(fault_of(path("none.exr")), "");
}

TEST_F(Exr, a_small_file_that_claims_a_large_picture_is_refused) {
    write_exr(path("a.exr"), sample(9, 40));
    std::string bytes = read_file(path("a.exr"));
    const std::size_t window = bytes.find("dataWindow");
    ASSERT_NE(window, std::string::npos);
    const std::size_t corner = window + std::string("dataWindow").size() + 1 + 6 + 4 + 8;
    std::ofstream(path("b.exr"), std::ios::binary | std::ios::trunc) << bytes;
    EXPECT_EQ(fault_of(path("b.exr")), "");
    const auto widened = [&](char by) {  // by so many times 65536 pixels
        std::string broken = bytes;
        broken[corner + 2] = by;
        std::ofstream(path("b.exr"), std::ios::binary | std::ios::trunc) << broken;
        return fault_of(path("b.exr"));
    };
    EXPECT_NE(widened(1).find("b.exr: claims 13109000 values in"), std::string::npos);
    EXPECT_NE(widened(64).find("b.exr: cannot read a picture of 4194313 x 40"), std::string::npos);
}

TEST_F(Exr, an_unwritable_place_is_an_error) {
    EXPECT_THROW(write_exr(path("no/a.exr"), sample(2, 2)), Error);
    EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace sunfleck::engine
