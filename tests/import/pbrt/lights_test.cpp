// Lights: pbrt-v4's scale, measured there on a plane of reflectance 0.5.
#include "import/pbrt/lights.h"

#include "image/image_files.h"
#include "import/pbrt/scene_text.h"

#include <array>
#include <utility>

namespace sunfleck::engine {
namespace {

template <class L>
L made(const std::string& statement) {
    return std::get<L>(read_world(statement).lights.at(0));
}

float value_of(const Spectrum& curve) {
    return curve.luminance();
}

TEST(Lights, of_a_point_have_an_intensity_or_power) {
    const auto plain = made<PointLight>(
        "Translate 1 0 0 Scale 2 2 2 LightSource \"point\" \"point3 from\" "
        "[ 1 2 3 ] \"rgb I\" [ 3 3 3 ] \"float scale\" 2");
    EXPECT_EQ(plain.position, Vec3d(3, 4, 6));
    EXPECT_NEAR(value_of(plain.curve), 6, 1e-4);
    const auto power = made<PointLight>("LightSource \"point\" \"float power\" 100");
    EXPECT_NEAR(0.5 / kPi * value_of(power.curve) / 4, 0.3166, 2e-4);  // distance 2
    EXPECT_NEAR(value_of(made<PointLight>("LightSource \"point\" \"float power\" 0").curve), 1,
                1e-4);
}

TEST(Lights, of_a_spot_have_a_cone_and_power) {
    const auto spot = made<SpotLight>(
        "LightSource \"spot\" \"float power\" 100 \"point3 from\" "
        "[ 0 0 1 ] \"point3 to\" [ 0 0 -5 ]");
    EXPECT_NEAR(0.5 / kPi * value_of(spot.curve) / 4, 5.562, 3e-3);  // distance 2
    EXPECT_NEAR(spot.cos_total, 0.8660254, 1e-7);
    EXPECT_NEAR(spot.cos_start, 0.9063078, 1e-7);
    EXPECT_EQ(spot.axis, Vec3d(0, 0, -1));
    EXPECT_NEAR(spot.power({}) * value_of(spot.curve), 100, 0.02);
    EXPECT_EQ(made<SpotLight>("LightSource \"spot\" \"float coneangle\" 10 \"float "
                              "conedeltaangle\" 20")
                  .cos_start,
              1);
}

TEST(Lights, far_away_shine_from_from_to_to) {
    const auto sun = made<DistantLight>(
        "Rotate 90 0 0 1 LightSource \"distant\" \"point3 from\" "
        "[ 2 0 0 ] \"point3 to\" [ 0 0 0 ] \"float scale\" 3");
    EXPECT_TRUE(sun.direction.equalWithAbsError({0, -1, 0}, 1e-12));
    EXPECT_NEAR(value_of(sun.curve), 3, 1e-3);
    const auto lit = made<DistantLight>(
        "LightSource \"distant\" \"rgb L\" [ 2 2 2 ] \"float "
        "illuminance\" 10");
    EXPECT_NEAR(value_of(lit.curve), 20, 1e-3);
    EXPECT_EQ(lit.direction, Vec3d(0, 0, 1));
}

TEST(Lights, from_a_sun_have_a_width) {
    const auto sun = made<SunLight>(
        "LightSource \"sun\" \"float angle\" 10 \"point3 from\" [ 0 0 2 ] \"point3 to\" [ 0 0 0 ] "
        "\"float illuminance\" 3");
    EXPECT_NEAR(value_of(sun.curve), 3, 1e-3);
    EXPECT_EQ(sun.direction, Vec3d(0, 0, -1));
    EXPECT_NEAR(1 - sun.versine, 0.9961947, 1e-6);  // cos 5 degrees
    EXPECT_THROW(read_world("LightSource \"sun\" \"float angle\" 0"), Error);
    EXPECT_THROW(read_world("LightSource \"sun\" \"float angle\" 200"), Error);
}

TEST(Lights, from_a_sky_are_two_of_one_statement) {
    const SceneDescription scene = read_world(
        "Rotate 90 1 0 0\nLightSource \"sky\" \"float azimuth\" 180 \"float elevation\" 90 "
        "\"float scale\" 2");
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.stated_in, (std::vector<std::uint32_t>{0, 0}));
    const auto& sun = std::get<SunLight>(scene.lights[1]);
    EXPECT_TRUE(sun.direction.equalWithAbsError({0, 1, 0}, 1e-12)) << sun.direction;
    EXPECT_NEAR(683 * value_of(sun.curve), 2 * 81.6e3, 300);  // lux
    EXPECT_THROW(read_world("LightSource \"sky\" \"float elevation\" -1"), Error);
    EXPECT_THROW(read_world("LightSource \"sky\" \"float turbidity\" 11"), Error);
}

TEST(Lights, from_everywhere_have_a_radiance_or_illuminance) {
    EXPECT_NEAR(value_of(made<InfiniteLight>("LightSource \"infinite\"").curve), 1, 1e-4);
    EXPECT_NEAR(
        value_of(made<InfiniteLight>("LightSource \"infinite\" \"float illuminance\" 1").curve),
        1 / kPi, 1e-4);
}

TEST(Lights, on_shapes_end_with_their_block) {
    const SceneDescription scene = read_world(
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 2 2 2 ] \"float scale\" 3 \"bool "
        "twosided\" true \"float power\" 7 Shape \"sphere\" AttributeEnd Shape \"sphere\"");
    ASSERT_TRUE(scene.shapes.at(0).emission);
    EXPECT_NEAR(value_of(scene.shapes[0].emission->radiance), 6, 1e-3);
    EXPECT_TRUE(scene.shapes[0].emission->two_sided);
    EXPECT_EQ(scene.shapes[0].emission->power, 7);
    EXPECT_FALSE(scene.shapes.at(1).emission);
    EXPECT_TRUE(scene.lights.empty());
}

TEST(Lights, on_interfaces_are_ignored) {
    const SceneDescription scene = read_world(
        "AreaLightSource \"diffuse\" NamedMaterial \"nothing\" Shape \"sphere\" "
        "MakeNamedMaterial \"nothing\" \"string type\" \"interface\" Shape \"sphere\" "
        "\"float alpha\" 0");
    EXPECT_FALSE(scene.shapes.at(0).emission);
    EXPECT_TRUE(scene.shapes.at(1).emission);
    EXPECT_EQ(warnings_with(scene, "on interfaces"), 1);
}

/// A colour space is one of the attributes; colours of Attribute keep the one they were given in.
TEST(Lights, have_the_colour_space_of_their_place) {
    const auto seen = [](const std::string& text) {
        const SceneDescription scene = read_world(text);
        return curve(scene.lights.back()).to_rgb();
    };
    const std::string light = "LightSource \"infinite\" \"rgb L\" [ .2 1 .3 ] ";
    const std::string p3 = "ColorSpace \"dci-p3\" ";
    const Vec3 plain(0.2F, 1, 0.3F);
    EXPECT_NEAR((seen(light) - plain).length(), 0, 1e-3F);
    EXPECT_NEAR((seen(p3 + light) - Vec3(0.0201F, 1.0337F, 0.2465F)).length(), 0, 0.01F)
        << seen(p3 + light);
    EXPECT_NEAR((seen("AttributeBegin " + p3 + "AttributeEnd " + light) - plain).length(), 0,
                1e-3F);
    const std::string kept = "Attribute \"light\" \"rgb L\" [ .2 1 .3 ] " + p3;
    EXPECT_NEAR((seen(kept + "LightSource \"infinite\"") - plain).length(), 0, 1e-3F);
    const Vec3 white = seen("ColorSpace \"aces2065-1\" LightSource \"infinite\"");
    EXPECT_GT(white.x, white.z + 0.05F);
    const SceneDescription cut = read_world(p3 + "LightSource \"infinite\" \"rgb L\" [ 0 1 0 ]");
    EXPECT_EQ(warnings_with(cut, "outside the gamut of sRGB"), 1);
}

TEST(Options, are_known_or_told) {
    const auto warnings = [](const std::string& option) {
        return read_text("Option " + option + " WorldBegin").warnings.entries().size();
    };
    EXPECT_EQ(warnings("\"string rendercoordsys\" \"world\""), 0U);
    EXPECT_EQ(warnings("\"pixelstats\" true"), 0U);
    EXPECT_EQ(warnings("\"disablePixelJitter\" false"), 0U);
    EXPECT_EQ(warnings("\"disablepixeljitter\" true"), 1U);
    EXPECT_EQ(warnings("\"seed\" 7"), 1U);
    EXPECT_EQ(warnings_with(read_text("Option \"gamma\" 2 WorldBegin"), "unknown Option"), 1);
}

/// Each number is a finite float; their product is none.
TEST(Lights, whose_products_overflow_floats_are_told_with_the_product) {
    const MemoryFiles files = {
        {"sky.pfm", testing_support::pfm_file("Pf\n1 1\n-1\n", {1e30F}, true)}};
    const std::string bright = "[ 1e20 1e20 1e20 ] \"float scale\" 1e20";
    const std::string sky = "\"string filename\" \"sky.pfm\" \"float scale\" 1e20";
    const std::string portal = "\"point3 portal\" [ 0 0 0 1 0 0 1 1 0 0 1 0 ] ";
    const std::array<std::pair<std::string, std::string>, 13> rows = {{
        {"LightSource \"point\" \"rgb I\" " + bright, "\"I\" times \"scale\""},
        {"LightSource \"spot\" \"rgb I\" " + bright, "\"I\" times \"scale\""},
        {"LightSource \"spot\" \"float coneangle\" 0.001 \"float power\" 1e38", "\"power\""},
        {"LightSource \"distant\" \"rgb L\" " + bright, "\"L\" times \"scale\""},
        {"LightSource \"distant\" \"blackbody L\" 6500 \"float scale\" 1e20 "
         "\"float illuminance\" 1e20",
         "\"L\" times \"scale\" times \"illuminance\""},
        {"LightSource \"infinite\" \"rgb L\" " + bright, "\"L\" times \"scale\""},
        {"LightSource \"infinite\" " + sky, "\"filename\" times \"scale\""},
        {"LightSource \"infinite\" " + portal + sky, "\"filename\" times \"scale\""},
        {"LightSource \"infinite\" " + portal + "\"rgb L\" " + bright, "\"L\" times"},
        {"LightSource \"goniometric\" " + sky, "\"filename\" times \"scale\""},
        {"LightSource \"projection\" " + sky, "\"filename\" times \"scale\""},
        {"AreaLightSource \"diffuse\" \"rgb L\" " + bright, "\"L\" times \"scale\""},
        {"AreaLightSource \"diffuse\" " + sky, "\"filename\" times \"scale\""},
    }};
    for (const auto& [text, product] : rows) {
        const std::string fault = world_error(text, files);
        EXPECT_TRUE(contains(fault, product) && contains(fault, "3.4e38")) << text << fault;
    }
}

TEST(Lights, of_a_thousand_million_are_read_as_they_are) {
    const auto sun = made<DistantLight>(
        "LightSource \"distant\" \"rgb L\" [ 1e9 1e9 1e9 ] \"float scale\" 1e20");
    EXPECT_NEAR(value_of(sun.curve), 1e29, 1e25);
    const auto brightest =
        made<PointLight>("LightSource \"point\" \"rgb I\" [ 1e7 1e7 1e7 ] \"float scale\" 1e31");
    EXPECT_NEAR(value_of(brightest.curve), 1e38, 1e34);
}

TEST(Lights, that_are_black_stay_so_whatever_their_power) {
    const MemoryFiles files = {
        {"night.pfm", testing_support::pfm_file("Pf\n1 1\n-1\n", {0}, true)}};
    EXPECT_EQ(world_error("LightSource \"goniometric\" \"string filename\" \"night.pfm\" "
                          "\"float power\" 5",
                          files),
              "");
    EXPECT_EQ(world_error("LightSource \"infinite\" \"rgb L\" [ 0 0 0 ] \"float illuminance\" 5"),
              "");
}

/// 683 cd are 1 W/sr.
TEST(Lights, of_luminaires_have_the_candela_of_their_file) {
    const MemoryFiles files = {
        {"a.IES", "TILT=NONE\n1 -1 683 3 1 1 2 0 0 0\n1 1 0\n0 90 180\n0\n3 2 1\n"}};
    const std::string light = "LightSource \"goniometric\" \"string filename\" \"a.IES\" ";
    const auto lamp = std::get<GoniometricLight>(read_world(light, files).lights.at(0));
    const auto brought = [&](const Vec3& point) {
        return lamp.sample_direct(point, Vec2(0), {})->factor * value_of(lamp.curve);
    };
    EXPECT_NEAR(brought({0, 2, 0}), 1.0 / 4, 0.01) << "the zenith";
    EXPECT_NEAR(brought({0, -2, 0}), 3.0 / 4, 0.01) << "the nadir";
    const auto strong =
        std::get<GoniometricLight>(read_world(light + "\"float power\" 7", files).lights.at(0));
    EXPECT_NEAR(strong.power({}) * value_of(strong.curve), 7, 0.01);
}

TEST(Lights, that_cannot_be_are_errors) {
    for (const char* text :
         {"LightSource \"moon\"", "LightSource \"diffuse\"", "AreaLightSource \"sphere\"",
          "LightSource \"point\" \"float scale\" -1",
          "LightSource \"distant\" \"point3 from\" [ 0 0 1 ]",
          "LightSource \"spot\" \"float coneangle\" 0",
          "LightSource \"spot\" \"float coneangle\" 200",
          "LightSource \"spot\" \"float conedeltaangle\" -1",
          "LightSource \"infinite\" \"rgb L\" [ 1 1 1 ] \"string filename\" \"x.exr\""})
        EXPECT_NE(world_error(text), "") << text;
}

}  // namespace
}  // namespace sunfleck::engine
