// Photon mapping against path tracing under varnish, on and behind glass and in media: within 1%,
// with 99% confidence; within 4% where photons bring all light to rough glass.
#include "render/path_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

TEST(PathEquivalence, red_wall) {
    expect_equivalent(diffuse_room("0.5 0 1  -1 0 1  0 0 1", 50), {80, 10, 10});
}

/// Varnished walls, smooth and satin: what lies below the coat is gathered, the coat followed.
TEST(PathEquivalence, varnish_on_a_diffuse_wall) {
    for (const char* roughness : {"0", "0.3"}) {
        SCOPED_TRACE(roughness);
        const Scene scene = scene_of(
            view("0 -1.4 1.2  0 .2 .5  0 0 1", 25, kSize) + diffuse("0.5 0.5 0.5") +
            quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
            "Material \"coateddiffuse\" \"rgb reflectance\" [0.7 0.3 0.2] \"float roughness\" " +
            roughness + " \"bool remaproughness\" false\n" +
            quad("-1 1 0  1 1 0  1 -.2 1.2  -1 -.2 1.2") +
            "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\nReverseOrientation\n" +
            diffuse("0.5 0.5 0.5") + quad("-.8 -1.6 2.5  .8 -1.6 2.5  .8 0 2.5  -.8 0 2.5"));
        expect_equivalent(scene, {90, 45, 120, 0.01, 0.01});
    }
}

TEST(PathEquivalence, rough_metal) {
    expect_equivalent(rough_objects("-.85 -1.5 1  -.85 .8 .85  0 0 1", 20),
                      {120, 10, 24, 0.005, 0.01});
}

/// A lamp behind smooth glass over rough metal: photons bring its light, the camera path must not.
TEST(PathEquivalence, rough_metal_lit_through_smooth_glass) {
    const Scene scene =
        scene_of(view("0 -1 .9  0 0 0  0 0 1", 20, kSize) +
                 "Material \"conductor\" \"float roughness\" 0.5 \"bool remaproughness\" false\n" +
                 quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") + "Material \"dielectric\"\n" +
                 box({-1, -1, 1}, {1, 1, 1.1}) +
                 "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\nReverseOrientation\n" +
                 diffuse("0.5 0.5 0.5") + quad("-.8 -.8 1.5  .8 -.8 1.5  .8 .8 1.5  -.8 .8 1.5"));
    expect_equivalent(scene, {160, 20, 20, 0.01, 0.01});
}

TEST(PathEquivalence, rough_glass) {
    expect_equivalent(rough_objects("0.6 -.1 1.7  .6 -.1 .5  0 1 0", 30),
                      {160, 26, 30, 0.01, 0.04});
}

/// A floor below a tank of glass full of ink, in which something clear lies; all stands in haze.
TEST(PathEquivalence, floor_below_a_tank_of_ink) {
    const auto medium = [](const char* name, const char* sigma) {
        return std::string("MakeNamedMedium \"") + name +
               "\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [0 0 0] \"rgb sigma_a\" [" +
               sigma + "]\n";
    };
    const Scene scene = scene_of(
        medium("ink", "1 3 5") + medium("haze", ".3 .2 .1") + "MediumInterface \"haze\"\n" +
        view("0 -1 .6  0 0 0  0 0 1", 20, kSize) + diffuse("0.5 0.5 0.5") +
        quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
        "AttributeBegin\nMaterial \"dielectric\"\nMediumInterface \"ink\" \"haze\"\n" +
        box({-1, -1, 0.8}, {1, 1, 1.2}) + "MediumInterface \"\" \"ink\"\nMaterial \"interface\"\n" +
        box({-.5, -.5, 0.9}, {0.5, 0.5, 1.1}) + "AttributeEnd\n" +
        "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\nReverseOrientation\n" +
        diffuse("0.5 0.5 0.5") + quad("-.8 -.8 1.5  .8 -.8 1.5  .8 .8 1.5  -.8 .8 1.5"));
    expect_equivalent(scene, {160, 0, 30, 0.01, 0.01});
    // All light comes through smooth glass: photons bring it whatever else is sampled.
    const auto once = [&](DirectLight direct, IndirectLight indirect) {
        return brightness(scene, equivalence_settings(direct, indirect), 2).mean;
    };
    const double by_photons = once(DirectLight::photons, IndirectLight::photons);
    EXPECT_NEAR(once(DirectLight::sampled, IndirectLight::photons) / by_photons, 1, 1e-9);
    EXPECT_NEAR(once(DirectLight::sampled, IndirectLight::sampled) / by_photons, 1, 1e-9);
}

TEST(PathEquivalence, floor_lit_through_rough_glass_and_by_rough_metal) {
    expect_equivalent(rough_objects("-.1 -.6 1.2  -.4 -.1 0  0 0 1", 25),
                      {60, 60, 30, 0.005, 0.01});
}

/// A room full of mist that scatters red light most, and forward.
TEST(PathEquivalence, room_full_of_coloured_mist) {
    const Scene scene = scene_of(
        "MakeNamedMedium \"mist\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [0.6 0.4 0.2] "
        "\"rgb sigma_a\" [0.02 0.05 0.1] \"float g\" 0.5\nMediumInterface \"\" \"mist\"\n" +
        view("0 -.9 1  0 1 .9  0 0 1", 60, kSize) + diffuse("0.6 0.6 0.6") +
        quad("-1 1 0  1 1 0  1 1 2  -1 1 2") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
        quad("-1 -1 2  -1 1 2  1 1 2  1 -1 2") + quad("-1 -1 0  -1 1 0  -1 1 2  -1 -1 2") +
        quad("1 -1 0  1 -1 2  1 1 2  1 1 0") + quad("-1 -1 0  -1 -1 2  1 -1 2  1 -1 0") +
        "AreaLightSource \"diffuse\" \"rgb L\" [10 9 7]\nReverseOrientation\n" +
        quad("-.4 -.2 1.9  .4 -.2 1.9  .4 .6 1.9  -.4 .6 1.9"));
    expect_equivalent(scene, {300, 30, 40, 0.01, 0.01});
}

/// A dense cloud far from the eye, of parts between which there is nothing. The tolerance is that
/// of cylinders a pixel wide at its outline.
TEST(PathEquivalence, cloud_before_a_sky) {
    std::string density;
    for (int i = 0; i < 6 * 6 * 6; ++i) density += i * 7 % 3 == 0 ? " 1" : " 0";
    const Scene scene = scene_of(
        view("0 -6 1  0 0 0  0 0 1", 18, kSize) +
        "LightSource \"infinite\" \"rgb L\" [.3 .4 .6]\n"
        "LightSource \"distant\" \"point3 from\" [2 -1 3] \"point3 to\" [0 0 0]\n"
        "MakeNamedMedium \"cloud\" \"string type\" \"uniformgrid\" \"integer nx\" 6 "
        "\"integer ny\" 6 \"integer nz\" 6 \"point3 p0\" [-.6 -.6 -.6] \"point3 p1\" [.6 .6 .6] "
        "\"spectrum sigma_s\" [200 20 900 20] \"spectrum sigma_a\" [200 0 900 0] \"float density\" "
        "[" +
        density + "]\nMaterial \"interface\"\nMediumInterface \"cloud\" \"\"\n" +
        box({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6}));
    expect_equivalent(scene, {60, 12, 12, 0.02, 0.05});
}

/// Fire on a floor beside a wall, cut by the ball that it is in.
TEST(PathEquivalence, fire_on_a_floor) {
    std::string density;
    std::string scale;
    for (int i = 0; i < 6 * 6 * 6; ++i) {
        density += " " + std::to_string(i * 7 % 5 * 0.6);
        scale += i * 11 % 3 == 0 ? " 5" : " 0.5";
    }
    const Scene scene = scene_of(
        view("0 -4 1.4  0 0 .7  0 0 1", 40, kSize) + diffuse("0.6 0.5 0.4") +
        quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") + quad("-2 1 0  2 1 0  2 1 3  -2 1 3") +
        "MakeNamedMedium \"fire\" \"string type\" \"uniformgrid\" \"integer nx\" 6 "
        "\"integer ny\" 6 \"integer nz\" 6 \"point3 p0\" [-.7 -.7 0] \"point3 p1\" [.7 .7 1.4] "
        "\"rgb sigma_a\" [1 1.5 2] \"rgb sigma_s\" [.4 .4 .4] \"rgb Le\" [6 3 1] "
        "\"float Lescale\" [" +
        scale + "] \"float density\" [" + density +
        "]\nAttributeBegin\nMaterial \"interface\"\nMediumInterface \"fire\" \"\"\n"
        "Translate 0 0 .8\nShape \"sphere\" \"float radius\" .75\nAttributeEnd\n");
    expect_equivalent(scene, {200, 30, 40, 0.01, 0.01});
}

}  // namespace
}  // namespace sunfleck::engine
