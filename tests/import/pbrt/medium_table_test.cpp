// Media of scene files: names, coefficients, who stands where, and what is told.
#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

const std::string kClear =
    "MakeNamedMedium \"ink\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [0 0 0] ";
const std::string kUse = "MediumInterface \"ink\" \"\" Shape \"sphere\" ";

float absorption(const SceneDescription& scene, std::size_t medium, float nm = 500) {
    return scene.media.all.at(medium).absorption(nm);
}

TEST(ReadMedia, that_only_absorb_say_nothing) {
    const SceneDescription scene = read_world(
        kClear + "\"spectrum sigma_a\" [400 2 600 4] \"float scale\" .5 \"float g\" .3 " + kUse);
    EXPECT_FLOAT_EQ(absorption(scene, 1), 1.5F);
    EXPECT_EQ(absorption(scene, 0), 0);
    EXPECT_TRUE(scene.warnings.entries().empty());
    EXPECT_EQ(scene.shapes[0].media, (MediumSides{1, 0}));
}

TEST(ReadMedia, have_pbrts_defaults_and_presets) {
    const SceneDescription plain =
        read_world("MakeNamedMedium \"ink\" \"string type\" \"homogeneous\" " + kUse);
    EXPECT_EQ(absorption(plain, 1), 1);
    EXPECT_EQ(plain.media.all.at(1).scattering(500), 1);
    EXPECT_EQ(plain.media.all.at(1).g, 0);
    EXPECT_TRUE(plain.warnings.entries().empty());
    const SceneDescription wine =
        read_world(kClear + "\"string preset\" \"Merlot\" \"float scale\" 2 " + kUse);
    const Spectrum merlot = Spectrum::rgb_unbounded({0.11632F, 0.25191F, 0.29434F});
    EXPECT_FLOAT_EQ(absorption(wine, 1), 2 * merlot(500));
    EXPECT_TRUE(contains(world_error(kClear + "\"string preset\" \"Merlo\" " + kUse), "Merlot"));
}

TEST(ReadMedia, that_scatter_have_a_mean_cosine) {
    const std::string foggy = "MakeNamedMedium \"ink\" \"string type\" \"homogeneous\" ";
    const SceneDescription scene = read_world(
        foggy + "\"spectrum sigma_s\" [400 2 600 4] \"float scale\" .5 \"float g\" .3 " + kUse);
    EXPECT_FLOAT_EQ(scene.media.all.at(1).scattering(500), 1.5F);
    EXPECT_FLOAT_EQ(scene.media.all.at(1).g, 0.3F);
    EXPECT_TRUE(contains(world_error(foggy + "\"float g\" -1 " + kUse), "not between -1 and 1"));
    EXPECT_TRUE(contains(world_error(foggy + "\"float g\" 1.5 " + kUse), "\"g\""));
}

TEST(ReadMedia, whose_density_overflows_floats_are_told_with_the_product) {
    const std::string fault =
        world_error(kClear + "\"rgb sigma_a\" [1e20 1e20 1e20] \"float scale\" 1e20 " + kUse);
    EXPECT_TRUE(contains(fault, "\"sigma_a\" times \"scale\"") && contains(fault, "3.4e38"))
        << fault;
}

TEST(ReadMedia, stand_by_the_state_of_the_graphics) {
    const SceneDescription scene = read_text(
        "MediumInterface \"air\" \"fog\" Camera \"perspective\" WorldBegin "
        "LightSource \"point\" AttributeBegin MediumInterface \"ink\" "
        "LightSource \"point\" Shape \"sphere\" AttributeEnd Shape \"sphere\" "
        "MediumInterface \"\" \"\" LightSource \"point\" Shape \"sphere\" " +
        kClear + kClear.substr(0, 17) + "fog" + kClear.substr(20) + kClear.substr(0, 17) + "air" +
        kClear.substr(20));
    // By their first use: fog 1, ink 2, air 3.
    EXPECT_EQ(scene.media.all.size(), 4U);
    EXPECT_EQ(scene.media.at_camera, 1U);
    ASSERT_EQ(scene.media.at_lights.size(), 3U);
    EXPECT_EQ(scene.media.at_lights[0].outside, 1U);
    EXPECT_EQ(scene.media.at_lights[1].outside, 2U);
    EXPECT_EQ(scene.media.at_lights[2].outside, 0U);
    ASSERT_EQ(scene.shapes.size(), 3U);
    EXPECT_EQ(scene.shapes[0].media, (MediumSides{2, 2}));
    EXPECT_EQ(scene.shapes[1].media, (MediumSides{3, 1}));
    EXPECT_EQ(scene.shapes[2].media, (MediumSides{0, 0}));
}

TEST(ReadMedia, that_are_not_simulated_are_told) {
    const auto warned = [](const std::string& medium, const std::string& part) {
        return warnings_with(read_world("MakeNamedMedium \"ink\" " + medium + kUse), part);
    };
    const std::string even = "\"string type\" \"homogeneous\" ";
    EXPECT_EQ(warned(even + "\"float scale\" 0 ", "scatters"), 0);
    EXPECT_EQ(warned(even + "\"rgb Le\" [1 0 0] ", "emits"), 0);
    EXPECT_EQ(warned(even + "\"rgb Le\" [1 0 0] \"rgb sigma_a\" [0 0 0] ", "emits nothing"), 1);
    EXPECT_EQ(warned(even + "\"float smell\" 2 ", "unused"), 1);
    const std::string coloured = "\"string type\" \"rgbgrid\" \"integer nx\" 2 ";
    EXPECT_EQ(
        warned(coloured + "\"rgb sigma_a\" [1 2 3 2 4 6] \"rgb sigma_s\" [1 1 1 2 2 2] ", "colour"),
        0);
    EXPECT_EQ(warned(coloured + "\"rgb sigma_a\" [1 2 3 3 2 1] ", "colours are their means"), 1);
    const SceneDescription unused =
        read_world("MakeNamedMedium \"a\" \"string type\" \"cloud\" Shape \"sphere\" ");
    EXPECT_EQ(warnings_with(unused, "medium"), 0);
}

TEST(ReadMedia, take_defaults_by_attribute) {
    const SceneDescription scene =
        read_world("Attribute \"medium\" \"rgb sigma_a\" [3 3 3] " + kClear + kUse);
    EXPECT_FLOAT_EQ(absorption(scene, 1), 3);
}

TEST(ReadMedia, that_cannot_be_are_errors) {
    EXPECT_NE(world_error(kUse), "");
    EXPECT_NE(world_error(kClear + kClear), "");
    EXPECT_NE(world_error(kClear + "\"float scale\" -1 " + kUse), "");
    EXPECT_NE(world_error("MakeNamedMedium \"ink\" "), "");
    EXPECT_NE(world_error("MakeNamedMedium \"ink\" \"string type\" \"fog\""), "");
}

TEST(ReadMedia, of_a_camera_that_another_one_replaces_need_not_be_made) {
    const std::string fog = "MediumInterface \"\" \"fog\" Camera \"perspective\" ";
    EXPECT_EQ(error_of(fog + "MediumInterface \"\" \"\" Camera \"perspective\" WorldBegin"), "");
    EXPECT_TRUE(contains(error_of(fog + "WorldBegin"), "there is no medium \"fog\""));
}

}  // namespace
}  // namespace sunfleck::engine
