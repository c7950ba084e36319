// Pictures as values, written and read again.
#include "library/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

namespace sunfleck {
namespace {

TEST(Picture, keeps_its_channels_when_it_is_written_and_read) {
    Renderer renderer(testing_support::ball(),
                      testing_support::quick_settings().set("aovs", "caustic,depth"));
    renderer.step(1);
    const Picture picture = renderer.picture();
    EXPECT_TRUE(picture.has("caustic.G"));
    EXPECT_TRUE(picture.has("depth.Z"));
    EXPECT_THROW(static_cast<void>(picture.channel("no.G")), Error);
    EXPECT_EQ(picture.channel("R").size(), 24U * 16U);

    const auto path = std::filesystem::path(testing::TempDir()) / "library_picture.exr";
    picture.save(path.string());
    const Picture again = Picture::load(path.string());
    ASSERT_EQ(again.channels().size(), picture.channels().size());
    EXPECT_EQ(testing_support::green(again), testing_support::green(picture));
    std::filesystem::remove(path);
    EXPECT_THROW(Picture::load(path.string()), Error);
    EXPECT_THROW(picture.save("picture.gif"), Error);
}

TEST(Picture, is_saved_as_the_settings_of_its_renderer_say) {
    const auto folder = std::filesystem::path(testing::TempDir());
    const auto saved = [&](const std::string& ending, const Settings& settings) {
        const std::string path = (folder / ("library_look" + ending)).string();
        Renderer renderer(testing_support::ball(), settings);
        renderer.step(1);
        renderer.picture().save(path);
        std::ifstream file(path, std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(file), {});
        std::filesystem::remove(path);
        return bytes;
    };
    const Settings plain = testing_support::quick_settings();
    EXPECT_EQ(saved(".png", plain), saved(".png", plain));
    for (const auto& [name, value, ending] : {std::tuple("tone", "agx", ".png"),
                                              {"png-bits", "16", ".png"},
                                              {"jpeg-quality", "30", ".jpg"},
                                              {"exr-half", "picture", ".exr"}})
        EXPECT_NE(saved(ending, plain), saved(ending, Settings(plain).set(name, value))) << name;
    EXPECT_THROW(saved(".exr", Settings(plain).set("exr-half", "nothing")), Error);
}

TEST(Picture, is_not_saved_with_an_exposure_that_is_none) {
    const Picture picture = Renderer(testing_support::ball()).picture();
    for (const double stops : {std::nan(""), HUGE_VAL, -101.0})
        EXPECT_THROW(picture.save("exposed.png", stops), Error) << stops;
    EXPECT_FALSE(std::filesystem::exists("exposed.png"));
}

TEST(Picture, outlives_its_renderer) {
    const auto picture = [] {
        Renderer renderer(testing_support::ball());
        return renderer.picture();
    }();
    EXPECT_EQ(picture.width(), 24);
    EXPECT_EQ(picture.channel("R")[0], 0);
}

}  // namespace
}  // namespace sunfleck
