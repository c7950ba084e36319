// The end of a medium around a scene: where it is, and when there is none.
#include "import/medium_border.h"

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

const std::string kFog =
    "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"spectrum sigma_a\" [200 .1 900 .1] "
    "\"spectrum sigma_s\" [200 0 900 0]\n";
const std::string kSun = "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n";
const std::string kFloor = diffuse("0.5 0.5 0.5") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0");

SceneDescription ended(const std::string& text) {
    SceneDescription scene = read_pbrt_text(text, "test.pbrt");
    end_outer_medium(scene);
    return scene;
}

std::string seen_from_above(const std::string& before) {
    return before + view("0 0 3  0 0 0  0 1 0", 2, 2);
}

double brightness(SceneDescription description) {
    RenderSettings settings;
    settings.photon.paths_per_pass = 1;
    return luminance(render_mean(Scene(std::move(description)), settings, 1).mean());
}

/// Floor and camera have a radius of 2.0616 around a height of 1.5.
TEST(MediumBorder, lets_the_sun_in_at_twice_the_radius) {
    const SceneDescription foggy =
        ended(seen_from_above(kFog + "MediumInterface \"\" \"fog\"\n") + kSun + kFloor);
    ASSERT_EQ(foggy.shapes.size(), 2U);
    ASSERT_EQ(foggy.warnings.entries().size(), 1U);
    const double clear = brightness(ended(seen_from_above("") + kSun + kFloor));
    const double way = 3 + 1.5 + 2 * std::sqrt(1 + 1 + 1.5 * 1.5);
    EXPECT_NEAR(brightness(foggy) / clear, std::exp(-0.1 * way), 1e-4);
}

TEST(MediumBorder, is_not_added_where_no_light_has_to_come_through) {
    const std::string in_fog = kFog + "MediumInterface \"\" \"fog\"\n";
    const std::string lamp = "LightSource \"point\" \"point3 from\" [0 0 2]\n";
    EXPECT_EQ(ended(seen_from_above(in_fog) + lamp + kFloor).shapes.size(), 1U);
    EXPECT_EQ(ended(seen_from_above("") + kSun + kFloor).shapes.size(), 1U);
    // A bubble of fog around the camera has an end.
    const std::string bubble =
        "AttributeBegin\nMaterial \"interface\"\nMediumInterface \"fog\" \"\"\nTranslate 0 0 3\n"
        "Shape \"sphere\"\nAttributeEnd\n";
    EXPECT_EQ(
        ended(seen_from_above(in_fog) + "MediumInterface \"\" \"\"\n" + bubble + kSun + kFloor)
            .shapes.size(),
        2U);
    const std::string cloud =
        "MakeNamedMedium \"fog\" \"string type\" \"cloud\"\nMediumInterface \"\" \"fog\"\n";
    EXPECT_EQ(ended(seen_from_above(cloud) + kSun + kFloor).shapes.size(), 1U);
}

/// A closed room of clear air in the fog: the fog is around the scene, not around the camera.
TEST(MediumBorder, is_around_what_is_around_the_camera) {
    const std::string window =
        "MediumInterface \"\" \"fog\"\nMaterial \"interface\"\nShape \"sphere\" \"float radius\" "
        "4\n";
    const SceneDescription scene =
        ended(seen_from_above(kFog) + kSun + window + "MediumInterface \"\" \"\"\n" + kFloor);
    ASSERT_EQ(scene.shapes.size(), 3U);
    EXPECT_GT(brightness(scene), 0);
}

}  // namespace
}  // namespace sunfleck::engine
