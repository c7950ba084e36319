// JPEG files that we write: read back by our reader, the same on every run.
#include "image/jpeg.h"

#include "image/read_file.h"
#include "image/read_image.h"
#include "image/srgb.h"
#include "sunfleck/error.h"
#include "temporary_folder.h"

namespace sunfleck::engine {
namespace {

using Jpeg = testing_support::TemporaryFolder;

/// A slow change of colour, with one small red field.
Picture soft_picture(int width, int height) {
    Picture picture{width, height, {}, {}};
    for (const char* name : {"R", "G", "B"}) picture.add(name);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>(y * width + x);
            const bool is_red = x / 3 == 2 && y / 3 == 2;
            picture.channels[0].values[i] = is_red ? 0.9F : static_cast<float>(x) / 64;
            picture.channels[1].values[i] = is_red ? 0.01F : static_cast<float>(y) / 64;
            picture.channels[2].values[i] = is_red ? 0.01F : 0.2F;
        }
    return picture;
}

float most_off(const Picture& picture, const Image& image) {
    float most = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const auto i = static_cast<std::size_t>(y * picture.width + x);
                most = std::max(most, std::abs(srgb_encode(image.at(x, y)[c]) -
                                               srgb_encode(picture.channels[c].values[i])));
            }
    return most;
}

TEST_F(Jpeg, what_is_written_is_read_back_nearly) {
    const Picture picture = soft_picture(37, 23);
    write_jpeg(path("a.jpg"), picture);
    const std::string bytes = read_file(path("a.jpg"));
    EXPECT_LT(most_off(picture, parse_image(bytes, "a.jpg")), 20.0F / 255);
    EXPECT_EQ(bytes.substr(6, 4), "JFIF");
    EXPECT_NE(bytes.find("\xFF\xC0"), std::string::npos) << "baseline";
    EXPECT_EQ(bytes.find("\xFF\xC2"), std::string::npos) << "not progressive";
}

TEST_F(Jpeg, the_same_picture_gives_the_same_bytes) {
    write_jpeg(path("a.jpg"), soft_picture(50, 40));
    write_jpeg(path("b.jpg"), soft_picture(50, 40));
    EXPECT_EQ(read_file(path("a.jpg")), read_file(path("b.jpg")));
}

/// Sampling factors stand in the frame's head: 0x11 for each component, or 0x22 for the first.
TEST_F(Jpeg, quality_rules_size_and_the_resolution_of_colour) {
    const auto bytes_at = [&](int quality) {
        write_jpeg(path("a.jpg"), soft_picture(64, 64), {}, quality);
        return read_file(path("a.jpg"));
    };
    const auto sampling = [](const std::string& bytes) {
        return static_cast<int>(bytes[bytes.find("\xFF\xC0") + 11]);
    };
    EXPECT_EQ(sampling(bytes_at(90)), 0x11);
    EXPECT_EQ(sampling(bytes_at(89)), 0x22);
    EXPECT_GT(bytes_at(100).size(), bytes_at(95).size());
    EXPECT_GT(bytes_at(95).size(), bytes_at(20).size());
}

TEST_F(Jpeg, tones_and_exposure_apply) {
    Picture picture{8, 8, {}, {}};
    for (const char* name : {"R", "G", "B"}) std::ranges::fill(picture.add(name).values, 0.09F);
    write_jpeg(path("a.jpg"), picture, {.exposure = 1, .tone = Tone::agx}, 100);
    const Image image = parse_image(read_file(path("a.jpg")), "a.jpg");
    EXPECT_NEAR(image.at(3, 3)[1], std::pow(0.5F, 2.2F), 0.005F);
}

TEST_F(Jpeg, what_jpeg_cannot_hold_is_refused) {
    Picture picture{65501, 1, {}, {}};
    for (const char* name : {"R", "G", "B"}) picture.add(name);
    try {
        write_jpeg(path("a.jpg"), picture);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("65500"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("write it as .png"), std::string::npos);
    }
    EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace sunfleck::engine
