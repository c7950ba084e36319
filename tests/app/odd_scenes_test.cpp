// Scenes with nothing in them, and pictures of one pixel.
#include "app/program.h"
#include "image/exr.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::Words;
using testing_support::write_text;

constexpr const char* kHead =
    "Film \"rgb\" \"integer xresolution\" 6 \"integer yresolution\" 4\n"
    "Camera \"perspective\"\nWorldBegin\n";
constexpr const char* kBall = "Translate 0 0 5\nShape \"sphere\"\n";

class OddScenes : public ProgramTest {
protected:
    /// Renders the text, which must work. @return what it said.
    std::string works(const std::string& text, const Words& words = {}) const {
        write_text(path("odd.pbrt"), text);
        const Ran ran = run(Words{"render", "odd.pbrt", "-o", "x.exr", "--passes", "17",
                                  "--photons-per-pass", "300", "--stats", "x.json"} +
                            words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(json("x.json")["dropped_nonfinite"], 0);
        return ran.err;
    }
    /// All pixels of a channel.
    std::vector<float> green() const { return read_exr(path("x.exr")).find("G")->values; }
};

const std::vector<float> kBlack(24, 0.0F);

TEST_F(OddScenes, no_light_is_black_and_said) {
    const std::string said = works(std::string(kHead) + kBall);
    EXPECT_NE(said.find("no light"), std::string::npos) << said;
    EXPECT_EQ(said.find("photons-per-pass"), std::string::npos) << said;
    EXPECT_EQ(green(), kBlack);
    EXPECT_EQ(json("x.json")["warnings"].size(), 1U);
}

TEST_F(OddScenes, nothing_at_all) {
    works(kHead);
    EXPECT_EQ(green(), kBlack);
    ASSERT_EQ(
        run({"render", "odd.pbrt", "-o", "x.exr", "--passes", "2", "--integrator", "path"}).code,
        0);
    EXPECT_EQ(green(), kBlack);
}

TEST_F(OddScenes, lights_without_surfaces) {
    works(std::string(kHead) + "LightSource \"point\"\nLightSource \"distant\"\n");
    EXPECT_EQ(green(), kBlack);
    works(std::string(kHead) + "LightSource \"infinite\" \"rgb L\" [2 2 2]\n");
    for (const float value : green()) EXPECT_NEAR(value, 2, 0.05);
}

TEST_F(OddScenes, light_without_power) {
    works(std::string(kHead) + "LightSource \"point\" \"rgb I\" [0 0 0]\n" + kBall);
    EXPECT_EQ(green(), kBlack);
}

TEST_F(OddScenes, camera_inside_a_closed_box_of_mirrors) {
    works(std::string(kHead) + "LightSource \"infinite\"\nMaterial \"conductor\"\n" +
          "Shape \"sphere\" \"float radius\" 2\n");
    EXPECT_EQ(green(), kBlack);
}

TEST_F(OddScenes, one_pixel) {
    for (const char* size : {"1x1", "1x7", "7x1"}) {
        const Ran ran = render({"-o", "x.exr", "-o", "x.png", "--resolution", size, "--passes",
                                "33", "--quiet", "--stats", "x.json"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_GT(green()[0], 0) << size;
        EXPECT_TRUE(json("x.json")["image"].contains("mean_std_error"));
    }
    ASSERT_EQ(render({"-o", "x.exr", "--crop", "15,16,11,12", "--passes", "2"}).code, 0);
    EXPECT_EQ(green().size(), 1U);
}

TEST_F(OddScenes, one_photon_a_pass) {
    const Ran ran = render({"-o", "x.exr", "--photons-per-pass", "1", "--passes", "20"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_NE(ran.err.find("passes no photon reached"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace sunfleck::engine
