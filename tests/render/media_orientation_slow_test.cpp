// One answer for all estimators, whichever way the normals of a shape full of a medium point.
//
// Under an even sky, the floor below and beside a body of glass full of tea, of which the camera
// sees nothing else. Where tea stood on the wrong side of the body photons and camera paths met it
// on different ways, 3% to a whole picture apart. Seeds 0 to 3, a confidence of 99%.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

struct Body {
    const char* name;
    const char* right;  // normals outwards
    const char* shape;  // the same body in another way
    bool is_warned_of;
};

constexpr const char* kSphere = R"(Shape "sphere" "float radius" 0.5)";
constexpr const char* kOctahedron =
    R"(Shape "trianglemesh" "point3 P" [.6 0 0  -.6 0 0  0 .6 0  0 -.6 0  0 0 .6  0 0 -.6]
"integer indices" [4 0 2  4 2 1  4 1 3  4 3 0  5 2 0  5 1 2  5 3 1  5 0 3])";
/// Its normals point to where its corners go round clockwise (pbrt-v4).
constexpr const char* kSubdivided =
    R"(Shape "loopsubdiv" "integer levels" 2 "point3 P" [.8 0 0 -.8 0 0 0 .8 0 0 -.8 0 0 0 .8 0 0 -.8]
"integer indices" [4 2 0  4 1 2  4 3 1  4 0 3  5 0 2  5 2 1  5 1 3  5 3 0])";
constexpr const char* kNested = R"(Shape "sphere" "float radius" 0.5
Material "dielectric" "float eta" 1.1
MediumInterface "milk" "tea"
Shape "sphere" "float radius" 0.3)";

constexpr std::array kBodies{
    Body{"reversed_sphere", kSphere, R"(ReverseOrientation Shape "sphere" "float radius" 0.5)",
         true},
    Body{"mirrored_sphere", kSphere, R"(Scale -1 1 1 Shape "sphere" "float radius" 0.5)", true},
    Body{"mirrored_and_reversed_sphere", kSphere,
         R"(Scale -1 1 1 ReverseOrientation Shape "sphere" "float radius" 0.5)", false},
    Body{"mesh_wound_inwards", kOctahedron,
         R"(Shape "trianglemesh" "point3 P" [.6 0 0  -.6 0 0  0 .6 0  0 -.6 0  0 0 .6  0 0 -.6]
"integer indices" [4 2 0  4 1 2  4 3 1  4 0 3  5 0 2  5 2 1  5 1 3  5 3 0])",
         true},
    Body{"loopsubdiv_wound_outwards", kSubdivided,
         R"(Shape "loopsubdiv" "integer levels" 2 "point3 P" [.8 0 0 -.8 0 0 0 .8 0 0 -.8 0 0 0 .8
0 0 -.8] "integer indices" [4 0 2  4 2 1  4 1 3  4 3 0  5 2 0  5 1 2  5 3 1  5 0 3])",
         true},
    Body{"nested_reversed_spheres", kNested, R"(ReverseOrientation Shape "sphere" "float radius" 0.5
Material "dielectric" "float eta" 1.1
MediumInterface "milk" "tea"
Shape "sphere" "float radius" 0.3)",
         true}};

std::string medium_of(const std::string& name, const std::string& absorption) {
    return "MakeNamedMedium \"" + name +
           R"(" "string type" "homogeneous" "rgb sigma_s" [0 0 0] "spectrum sigma_a" [200 )" +
           absorption + " 900 " + absorption + "]\n";
}

/// @param eta  the glass's; where normals point into it, it refracts as a hollow in glass.
Scene scene_with(const std::string& body, const std::string& eta) {
    return scene_of(view("1.5 0 .3  .7 0 0  0 0 1", 30, 8) +
                    "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + medium_of("tea", "1.2") +
                    medium_of("milk", "3") + diffuse("0.5 0.5 0.5") +
                    quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                    "AttributeBegin\nTranslate 0 0 .7\nMaterial \"dielectric\" \"float eta\" " +
                    eta + "\nMediumInterface \"tea\" \"\"\n" + body + "\nAttributeEnd\n");
}

Estimate brightness_by(Integrator integrator, const Scene& scene) {
    RenderSettings settings;
    settings.integrator = integrator;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 20'000;
    settings.camera.radius = 0.02;
    return Estimate::over(4, [&](int seed) {
        settings.seed = static_cast<std::uint64_t>(seed);
        return luminance(render_mean(scene, settings, 16).mean());
    });
}

class MediaOrientation : public testing::TestWithParam<Body> {};

void expect_one_answer(const Scene& scene) {
    const Estimate expected = brightness_by(Integrator::path, scene);
    for (const Integrator integrator : {Integrator::sppm, Integrator::bdpt, Integrator::light}) {
        const Estimate seen = brightness_by(integrator, scene);
        EXPECT_LT(worst_ratio(seen, expected), 0.1)
            << static_cast<int>(integrator) << ": " << seen.mean / expected.mean;
    }
}

TEST_P(MediaOrientation, is_one_answer_for_all_estimators) {
    expect_one_answer(scene_with(GetParam().shape, "1.3"));
}

/// Where nothing is refracted the normals tell nothing but where the medium is.
TEST_P(MediaOrientation, has_the_medium_within) {
    const Estimate seen = brightness_by(Integrator::path, scene_with(GetParam().shape, "1"));
    const Estimate expected = brightness_by(Integrator::path, scene_with(GetParam().right, "1"));
    EXPECT_LT(worst_ratio(seen, expected), 0.06) << seen.mean / expected.mean;
}

TEST_P(MediaOrientation, is_warned_of_by_shape) {
    std::string lines;
    const Scene scene = scene_with(GetParam().shape, "1.3");
    for (const auto& entry : scene.warnings().entries()) lines += entry.line() + "\n";
    EXPECT_EQ(lines.find("point into it") != std::string::npos, GetParam().is_warned_of) << lines;
    EXPECT_EQ(lines.find("does not name") != std::string::npos, false) << lines;
}

/// In a hollow of tea, lit by a lamp that names it; the camera names nothing.
TEST(MediaAround, a_camera_is_that_which_a_light_names) {
    expect_one_answer(
        scene_of(view("0 0 0  1 0 0  0 0 1", 90, 8) + medium_of("tea", "0.4") +
                 "AttributeBegin\nMediumInterface \"\" \"tea\"\n"
                 "LightSource \"point\" \"point3 from\" [0 .5 .2]\nMaterial \"interface\"\n"
                 "ReverseOrientation\nShape \"sphere\" \"float radius\" 2\nAttributeEnd\n" +
                 diffuse(".1 .1 .1") + "Shape \"sphere\" \"float radius\" 3\n"));
}

/// A lamp that names nothing, in a ball of tea above a floor.
TEST(MediaAround, a_lamp_is_that_of_the_shape_around_it) {
    for (const char* lamp :
         {"LightSource \"point\" \"point3 from\" [.1 .2 1]\n",
          "AttributeBegin\nTranslate 0 0 1\nAreaLightSource \"diffuse\" \"rgb L\" [9 9 9]\n"
          "Shape \"sphere\" \"float radius\" .2\nAttributeEnd\n"})
        expect_one_answer(
            scene_of(view("3 0 1  .9 0 0  0 0 1", 20, 8) + medium_of("tea", "1.2") +
                     diffuse(".5 .5 .5") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") + lamp +
                     "AttributeBegin\nTranslate 0 0 1\nMaterial \"interface\"\n"
                     "MediumInterface \"tea\" \"\"\nShape \"sphere\" \"float radius\" .8\n"
                     "AttributeEnd\n"));
}

INSTANTIATE_TEST_SUITE_P(Of, MediaOrientation, testing::ValuesIn(kBodies),
                         [](const auto& body) { return std::string(body.param.name); });

}  // namespace
}  // namespace sunfleck::engine
