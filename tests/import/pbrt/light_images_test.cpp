// Infinite lights with pictures: directions, scale, illuminance, and what cannot be.
#include "import/pbrt/light_images.h"

#include "image/image_files.h"
#include "import/pbrt/scene_text.h"
#include "light/light.h"

#include <limits>

namespace sunfleck::engine {
namespace {

using testing_support::pfm_file;

/// Rows of a PFM come from the bottom: the texel (1, 0), at the top right, is (8, 0, 0).
const MemoryFiles kFiles = {
    {"sky.pfm", pfm_file("PF\n2 2\n-1\n", {1, 1, 1, 0, 4, 0, 0, 0, 2, 8, 0, 0}, true)},
    {"white.pfm", pfm_file("Pf\n64 64\n-1\n", std::vector<float>(4096, 1), true)},
    {"strip.pfm", pfm_file("PF\n3 1\n-1\n", std::vector<float>(9, 1), true)},
    {"wide.pfm", pfm_file("PF\n2 1\n-1\n", std::vector<float>(6, 1), true)},
    {"odd.pfm", pfm_file("Pf\n1 1\n-1\n", {std::numeric_limits<float>::infinity()}, true)}};

const std::string kSky = "LightSource \"infinite\" \"string filename\" \"sky.pfm\" ";

Vec3 radiance(const SceneDescription& scene, const Vec3& w, const Vec3& from = Vec3(0)) {
    const Light& light = scene.lights.at(0);
    const EnvironmentRadiance met = environment_radiance(light, from, w.normalized());
    return met.rgb.value_or(Vec3(1)) * (met.factor * curve(light).luminance());
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
    EXPECT_EQ(warnings_with(stretched, "scale and shear are ignored"), 1);
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

/// What a light that is a point sends towards `point`: rgb of its intensity.
Vec3 intensity(const SceneDescription& scene, const Vec3& point) {
    const Light& light = scene.lights.at(0);
    const auto s = sample_direct(light, point, {0.5F, 0.5F}, {});
    if (!s) return Vec3(0);
    return s->rgb.value_or(Vec3(1)) *
           (s->factor * s->distance * s->distance * curve(light).luminance());
}

/// y is up for them, as in pbrt-v4.
TEST(LightPictures, of_goniometric_lights_are_means_of_colours) {
    const std::string light =
        "Translate 1 0 0 LightSource \"goniometric\" \"string filename\" \"sky.pfm\" ";
    const SceneDescription plain = read_world(light + "\"float scale\" 3", kFiles);
    expect_near(intensity(plain, Vec3(1, 0, 0) + Vec3(1, 2, -1)), Vec3(8));
    expect_near(intensity(plain, Vec3(1, 0, 0) + Vec3(-1, 2, 1)), Vec3(3));
    const SceneDescription power = read_world(light + "\"float power\" 10", kFiles);
    EXPECT_NEAR(sunfleck::engine::power(power.lights[0], {}) *
                    static_cast<double>(curve(power.lights[0]).luminance()),
                10, 1e-3);
    const SceneDescription bare = read_world("LightSource \"goniometric\"");
    EXPECT_TRUE(std::holds_alternative<PointLight>(bare.lights.at(0)));
    EXPECT_EQ(warnings_with(bare, "is read as a point light"), 1);
}

/// Along z, y up, x to the right; the upper right texel of 2 x 2 is (8, 0, 0).
TEST(LightPictures, of_projections_stand_upright) {
    const std::string light = "LightSource \"projection\" \"float fov\" 60 \"string filename\" ";
    const SceneDescription sky = read_world(light + "\"sky.pfm\" \"float scale\" 2", kFiles);
    expect_near(intensity(sky, {1, 1, 4}), Vec3(16, 0, 0));
    expect_near(intensity(sky, {-1, 1, 4}), Vec3(0, 0, 4));
    expect_near(intensity(sky, {-1, -1, 4}), Vec3(2, 2, 2));
    expect_near(intensity(sky, {1, -1, 4}), Vec3(0, 8, 0));
    expect_near(intensity(sky, {-0.56F, 0, 1}), Vec3(2, 2, 2));
    expect_near(intensity(sky, {-0.59F, 0, 1}), Vec3(0));  // tan 30 degrees is 0.577
    expect_near(intensity(sky, {1, 1, -4}), Vec3(0));
    // Twice as wide as high: the fov is that of the height.
    const SceneDescription wide = read_world(light + "\"wide.pfm\" \"float power\" 7", kFiles);
    EXPECT_GT(intensity(wide, {1.14F, 0.56F, 1}).x, 0);
    EXPECT_EQ(intensity(wide, {1.17F, 0, 1}).x, 0);
    EXPECT_EQ(intensity(wide, {0, 0.6F, 1}).x, 0);
    EXPECT_NEAR(sunfleck::engine::power(wide.lights[0], {}) *
                    static_cast<double>(curve(wide.lights[0]).luminance()),
                7, 1e-3);
    const auto error = [&](const std::string& text) { return world_error(text, kFiles); };
    EXPECT_TRUE(contains(error("LightSource \"projection\""), "without its image"));
    EXPECT_NE(error(light + "\"sky.pfm\" \"float fov\" 180"), "");
}

TEST(LightPictures, of_area_lights_lie_on_their_shapes) {
    const std::string light = "AreaLightSource \"diffuse\" \"string filename\" \"wide.pfm\" ";
    const SceneDescription scene =
        read_world(light + "\"float scale\" 3 \"float power\" 5 Shape \"sphere\"", kFiles);
    const AreaEmission& emission = scene.shapes.at(0).emission.value();
    EXPECT_NEAR(emission.radiance.luminance(), 3, 1e-3);
    EXPECT_EQ(emission.power, 5);
    EXPECT_EQ(emission.image->resolution(), Vec2i(2, 1));
    EXPECT_TRUE(scene.warnings.entries().empty());
    EXPECT_TRUE(contains(world_error(light + "\"rgb L\" [1 1 1]", kFiles), "\"L\" and"));
}

/// The portal x, y in [-1, 1] at z = 1, the sky above it; texels of 2 x 2 blend.
const std::string kPortal = "\"point3 portal\" [-1 -1 1  -1 1 1  1 1 1  1 -1 1] ";
const std::string kPortalDown = "\"point3 portal\" [-1 -1 1  1 -1 1  1 1 1  -1 1 1] ";

TEST(LightPictures, behind_portals_are_seen_through_them_alone) {
    const auto expect_edges = [](const SceneDescription& scene, const Vec3& lit) {
        expect_near(radiance(scene, {0, 0, 1}), lit);
        expect_near(radiance(scene, {0.98F, -0.98F, 1}), lit);
        expect_near(radiance(scene, {1.02F, 0, 1}), Vec3(0));
        expect_near(radiance(scene, {1.02F, 0, 1}, {-0.1F, 0, 0}), lit);
        expect_near(radiance(scene, {0, 0, -1}), Vec3(0));
        expect_near(radiance(scene, {0, 0, 1}, {0, 0, 1.5F}), Vec3(0));
        expect_near(radiance(scene, {0, 0, -1}, {0, 0, 1.5F}), Vec3(0));
    };
    // Corners are those of the world, whatever the matrix.
    const std::string white = "Translate 9 9 9 LightSource \"infinite\" " + kPortal;
    expect_edges(read_world(white + "\"string filename\" \"white.pfm\"", kFiles), Vec3(1));
    expect_edges(read_world(white + "\"float scale\" 3 \"rgb L\" [1 2 1]"),
                 Vec3(3 * (0.2126F + 2 * 0.7152F + 0.0722F)));
    expect_near(
        radiance(read_world("LightSource \"infinite\" " + kPortalDown), {0, 0, -1}, {0, 0, 2}),
        Vec3(1));
    expect_near(radiance(read_world(white + "\"float illuminance\" 5"), {0, 0, 1}),
                Vec3(5 / (2 * kPi)));
}

/// Far from the other quadrants each shows its own colour, on the side where it is.
TEST(LightPictures, behind_portals_keep_their_directions) {
    const SceneDescription sky = read_world(kSky + kPortal, kFiles);
    const auto greatest = [&](const Vec3& w) {
        const Vec3 rgb = radiance(sky, w);
        return rgb.x > rgb.y ? (rgb.x > rgb.z ? 0 : 2) : (rgb.y > rgb.z ? 1 : 2);
    };
    EXPECT_EQ(greatest({0.9F, -0.9F, 1}), 0);
    EXPECT_EQ(greatest({0.9F, 0.9F, 1}), 1);
    EXPECT_GT(radiance(sky, {-0.9F, -0.9F, 1}).z, radiance(sky, {0.9F, 0.9F, 1}).z);
    const SceneDescription turned = read_world("Rotate 90 0 0 1 " + kSky + kPortal, kFiles);
    expect_near(radiance(turned, {0.9F, 0.9F, 1}), radiance(sky, {0.9F, -0.9F, 1}));
}

TEST(LightPictures, behind_bad_portals_are_errors) {
    const auto error = [](const std::string& points) {
        return world_error("LightSource \"infinite\" \"point3 portal\" [" + points + "]");
    };
    EXPECT_TRUE(contains(error("0 0 0 1 0 0 1 1 0"), "a portal of 3 points"));
    for (const char* points : {"0 0 0  1 0 0  1 1 0  0 1 0.1", "0 0 0  1 0 0  2 1 0  1 1 0",
                               "0 0 0  0 0 0  1 1 0  1 1 0", "0 0 0  1 1 0  1 0 0  0 1 0"})
        EXPECT_TRUE(contains(error(points), "not a rectangle")) << points;
}

TEST(LightPictures, of_latitude_and_longitude_are_taken_as_they_are_with_a_warning) {
    const SceneDescription scene =
        read_world("LightSource \"infinite\" \"string filename\" \"wide.pfm\"", kFiles);
    const auto& light = std::get<ImageInfiniteLight>(scene.lights.at(0));
    EXPECT_FALSE(light.map.has_equal_areas());
    EXPECT_NEAR(light.environment_radiance(Vec3(0), {0, 0, 1}).factor, 1, 1e-6);
    EXPECT_EQ(warnings_with(scene, "a map of latitude and longitude"), 1);
}

TEST(LightPictures, that_cannot_be_are_errors) {
    const auto error = [](const std::string& text) { return world_error(text, kFiles); };
    const std::string light = "LightSource \"infinite\" \"string filename\" ";
    EXPECT_TRUE(contains(error(light + "\"strip.pfm\""), "3 x 1 texels"));
    const SceneDescription odd = read_world(light + "\"odd.pfm\"", kFiles);
    EXPECT_EQ(warnings_with(odd, "are not finite, the first at (0, 0)"), 1);
    EXPECT_TRUE(contains(error(light + "\"none.pfm\""), "none.pfm"));
    EXPECT_NE(error(light + "\"sky.pfm\" \"rgb L\" [1 1 1]"), "");
    EXPECT_NE(error("Scale 0 1 1 " + kSky), "");
}

}  // namespace
}  // namespace sunfleck::engine
