// Dark pictures: what is said of them is true, and nothing is said of bright ones.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::Words;
using testing_support::write_text;

const char* const kHead = R"(LookAt 0 -4 2.5  0 0 0  0 0 1
Camera "perspective" "float fov" 35
Film "rgb" "integer xresolution" 12 "integer yresolution" 12
WorldBegin
)";
const char* const kSky = "LightSource \"infinite\" \"rgb L\" [.3 .3 .3]\n";
const char* const kSun = "LightSource \"distant\" \"point3 from\" [-2 -1 4] \"rgb L\" [2 2 2]\n";
const char* const kLamp = "LightSource \"point\" \"point3 from\" [0 0 3]\n";
const char* const kFloor = "Shape \"disk\" \"float radius\" 3\n";
const char* const kGlass =
    "AttributeBegin\nTranslate 0 0 1\nMaterial \"dielectric\"\nShape \"sphere\"\nAttributeEnd\n";

class Darkness : public ProgramTest {
protected:
    /// What is said of a picture, beside its line at the end.
    std::string said(const std::string& scene, const Words& words = {}) const {
        write_text(path("dark.pbrt"), kHead + scene);
        const Ran ran = run(Words{"render", "dark.pbrt", "-o", "x.exr", "--log-level", "warning"} +
                            (words.empty() ? Words{"--passes", "3"} : words));
        EXPECT_EQ(ran.code, 0) << ran.err;
        return ran.err;
    }
    static void expect_found(const std::string& said, const std::string& text) {
        EXPECT_NE(said.find(text), std::string::npos) << said;
    }
};

/// Photons leave for the sky, and nothing is missing.
TEST_F(Darkness, is_not_where_all_light_is_direct) {
    for (const char* light : {kSky, kSun, kLamp}) {
        EXPECT_EQ(said(std::string(light) + kFloor), "");
        EXPECT_EQ(said(std::string(light) + "Shape \"sphere\" \"float radius\" .5\n"), "");
    }
}

/// Nothing bends light: no photon is of use, and trials leave indirect light to camera paths.
TEST_F(Darkness, is_not_where_camera_paths_bring_indirect_light) {
    const std::string wall =
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] "
        "\"point3 P\" [-3 1 0  3 1 0  3 1 3  -3 1 3]\n";
    for (const char* light : {kSky, kSun, kLamp}) {
        EXPECT_EQ(said(light + (kFloor + wall), {"--passes", "3", "--stats", "x.json"}), "");
        EXPECT_EQ(json("x.json")["epochs"][0]["indirect"], "sampled");
    }
}

/// All light in the shadow of the ball is to come through it.
TEST_F(Darkness, of_light_that_photons_did_not_bring_is_told_with_its_share) {
    const Words few{"--passes", "1", "--photons-per-pass", "1", "--radius", "1e-5"};
    const std::string text = said(std::string(kSun) + kFloor + kGlass, few);
    expect_found(text, "no photon reached");
    expect_found(text, "% of the picture lacks light");
}

TEST_F(Darkness, inside_an_object_is_told) {
    const std::string ball =
        "AttributeBegin\nTranslate 0 -4 2.5\nShape \"sphere\" \"float radius\" .5\nAttributeEnd\n";
    const std::string text = said(kSun + ball + kFloor, {"--passes", "2", "--photon-sampler",
                                                         "uniform", "--photons-per-pass", "1000"});
    expect_found(text, "the picture is black");
    expect_found(text, "inside an object");
}

/// At once: the time that is given for it is an hour.
TEST_F(Darkness, that_is_known_before_is_written_at_once_with_its_reason) {
    const Words hour{"--time", "1h", "--target-error", "1%"};
    expect_found(said(kFloor, hour), "the scene has no light");
    expect_found(said(kFloor + std::string("LightSource \"point\" \"float scale\" 0\n"), hour),
                 "no light of the scene has any power");
    expect_found(said(kLamp, hour), "nothing can be seen");
    expect_found(said(std::string(kLamp) + "Translate 0 0 9\n" + kFloor, hour),
                 "the camera sees no surface and no light");
}

}  // namespace
}  // namespace sunfleck::engine
