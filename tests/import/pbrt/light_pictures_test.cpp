// Infinite lights with pictures: directions, scale, illuminance, and what cannot be.
#include "import/pbrt/light_pictures.h"

#include "image/image_files.h"
#include "import/pbrt/scene_text.h"

#include <limits>

namespace sunfleck {
namespace {

using testing_support::pfm_file;

/// Rows of a PFM come from the bottom: the texel (1, 0), at the top right, is (8, 0, 0).
const MemoryFiles kFiles = {
    {"sky.pfm", pfm_file("PF\n2 2\n-1\n", {1, 1, 1, 0, 4, 0, 0, 0, 2, 8, 0, 0}, true)},
    {"white.pfm", pfm_file("Pf\n64 64\n-1\n", std::vector<float>(4096, 1), true)},
    {"wide.pfm", pfm_file("PF\n2 1\n-1\n", std::vector<float>(6, 1), true)},
    {"odd.pfm", pfm_file("Pf\n1 1\n-1\n", {std::numeric_limits<float>::infinity()}, true)}};

const std::string kSky = "LightSource \"infinite\" \"string filename\" \"sky.pfm\" ";

Vec3 radiance(const SceneDescription& scene, const Vec3& w) {
    const Light& light = scene.lights.at(0);
    const Beyond met = beyond(light, w.normalized());
    return met.tint.value_or(Vec3(1)) * (met.factor * curve(light).luminance());
}

void expect_near(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR((a - b).length(), 0, 1e-3F) << a;
}

TEST(LightPictures, show_texels_by_quadrants_of_x_and_y) {
    const SceneDescription sky = read_world(kSky + "\"float scale\" 3", kFiles);
    expect_near(radiance(sky, {1, -1, 2}), Vec3(24, 0, 0));
    expect_near(radiance(sky, {1, -1, -2}), Vec3(24, 0, 0));
    expect_near(radiance(sky, {-1, -1, 0.1F}), Vec3(0, 0, 6));
    expect_near(radiance(sky, {-1, 1, 1}), Vec3(3, 3, 3));
    expect_near(radiance(sky, {1, 1, 1}), Vec3(0, 12, 0));
}

TEST(LightPictures, are_turned_by_the_matrix) {
    const SceneDescription sky = read_world("Rotate 90 0 0 1 Scale 2 2 -2 " + kSky, kFiles);
    expect_near(radiance(sky, {1, 1, 2}), Vec3(8, 0, 0));
    EXPECT_EQ(sky.warnings.entries().size(), 0U);
    const SceneDescription stretched = read_world("Scale 1 2 3 " + kSky, kFiles);
    expect_near(radiance(stretched, {1, -0.1F, 2}), Vec3(8, 0, 0));
    EXPECT_EQ(warnings_with(stretched, "not stretched"), 1);
}

/// As pbrt-v4 has it: twice what the name says.
TEST(LightPictures, of_illuminance_have_the_scale_of_pbrt) {
    const SceneDescription white = read_world(
        "LightSource \"infinite\" \"string filename\" \"white.pfm\" \"float illuminance\" 3",
        kFiles);
    EXPECT_NEAR(radiance(white, {0, 0, 1}).x, 2 * 3 / kPi, 0.04);  // texels at the horizon
    const SceneDescription plain =
        read_world("LightSource \"infinite\" \"string filename\" \"white.pfm\"", kFiles);
    EXPECT_NEAR(radiance(plain, {0, 0, 1}).x, 1, 1e-4);
}

TEST(LightPictures, that_cannot_be_are_errors) {
    const auto error = [](const std::string& text) { return world_error(text, kFiles); };
    const std::string light = "LightSource \"infinite\" \"string filename\" ";
    EXPECT_TRUE(contains(error(light + "\"wide.pfm\""), "2 x 1 texels"));
    EXPECT_TRUE(contains(error(light + "\"odd.pfm\""), "texel (0, 0) of \"odd.pfm\" is not"));
    EXPECT_TRUE(contains(error(light + "\"none.pfm\""), "none.pfm"));
    EXPECT_NE(error(light + "\"sky.pfm\" \"rgb L\" [1 1 1]"), "");
    EXPECT_NE(error("Scale 0 1 1 " + kSky), "");
    EXPECT_EQ(
        warnings_with(read_world(kSky + "\"point3 portal\" [0 0 0 1 0 0 1 1 0 0 1 0]", kFiles),
                      "portals are ignored"),
        1);
}

}  // namespace
}  // namespace sunfleck
