// Textures of scene files: every class with its defaults, images by name, and what is refused.
#include "image/image_files.h"
#include "import/pbrt/scene_text.h"
#include "texture/kinds.h"

namespace sunfleck::engine {
namespace {

using testing_support::pfm_file;

std::string world_error(const std::string& text, const MemoryFiles& files = {}) {
    return error_of("WorldBegin\n" + text, files);
}

TexturePoint at(const Vec3& position, const Vec2& uv = {0, 0}) {
    return {position, {0, 0, 1}, uv};
}

/// The float texture "t" of the text, by way of a shape's alpha.
Cover number(const std::string& text, const MemoryFiles& files = {}) {
    return read_world(text + " Shape \"sphere\" \"texture alpha\" \"t\"", files)
        .shapes.at(0)
        .placed.cover;
}

float value(const Cover& texture, const Vec3& position, const Vec2& uv = {0, 0}) {
    Hit hit;
    hit.position = position;
    hit.normal = {0, 0, 1};
    hit.uv = uv;
    return texture(hit);
}

SpectrumTexture colour(const std::string& text, const MemoryFiles& files = {}) {
    const SceneDescription scene = read_world(
        text + " Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"", files);
    return std::get<DiffuseMaterial>(scene.materials.at(1)).reflectance;
}

std::string t(const std::string& kind, const std::string& rest) {
    return "Texture \"t\" \"" + kind + "\" " + rest;
}

TEST(Textures, constants_count_as_numbers) {
    const SceneDescription scene = read_world(
        "Texture \"c\" \"spectrum\" \"constant\" \"rgb value\" [ .1 .1 .1 ] Texture \"r\" "
        "\"float\" \"constant\" \"float value\" .25 Material \"diffuse\" \"texture reflectance\" "
        "\"c\" Shape \"sphere\" Material \"dielectric\" \"texture roughness\" \"r\" Shape "
        "\"sphere\"");
    EXPECT_EQ(std::get<DiffuseMaterial>(scene.materials.at(1)).reflectance.curve()(500), 0.1F);
    const auto& glass = std::get<DielectricMaterial>(scene.materials.at(2));
    EXPECT_TRUE(glass.roughness.is_constant());
    EXPECT_FLOAT_EQ(glass.roughness.alphas({}).x, 0.5F);
}

TEST(Textures, have_the_defaults_of_pbrt) {
    const Vec2 uv(0.25F, 0.75F);
    EXPECT_FLOAT_EQ(value(number(t("float", "\"bilerp\"")), Vec3(0), uv), 0.75F);
    EXPECT_FLOAT_EQ(value(number(t("float", "\"mix\"") + " # comment\n"), Vec3(0)), 0.5F);
    EXPECT_EQ(value(number(t("float", "\"checkerboard\"")), Vec3(0), {0.5F, 1.5F}), 0);
    EXPECT_EQ(value(number(t("float", "\"checkerboard\"")), Vec3(0), {0.5F, 0.5F}), 1);
    EXPECT_EQ(value(number(t("float", "\"checkerboard\" \"integer dimension\" 3")),
                    {0.5F, 0.5F, 1.5F}, {0.5F, 0.5F}),
              0);
    EXPECT_EQ(value(number(t("float", "\"dots\"")), Vec3(0), {0, 1}), 1);
    EXPECT_EQ(value(number(t("float", "\"directionmix\" \"vector3 dir\" [ 0 0 2 ]")), Vec3(0)), 0);
    const Vec3 p(1.3F, 2.7F, -0.4F);
    EXPECT_FLOAT_EQ(value(number(t("float", "\"fbm\"")), p), fbm(p, {8, 0.5F}));
    EXPECT_FLOAT_EQ(
        value(number(t("float", "\"wrinkled\" \"integer octaves\" 3 \"float roughness\" .3")), p),
        turbulence(p, {3, 0.3F}));
    EXPECT_NEAR(value(number(t("float", "\"windy\"")), p), -0.00238778F, 1e-5F);
    EXPECT_FALSE(colour(t("spectrum", "\"marble\"")).is_constant());
}

TEST(Textures, stand_in_the_frame_of_their_statement) {
    const std::string text =
        "Translate 5 0 0 Scale 2 2 2 " + t("float", "\"fbm\" \"integer octaves\" 2") + " Identity";
    EXPECT_NEAR(value(number(text), {7.6F, 5.4F, -0.8F}), fbm({1.3F, 2.7F, -0.4F}, {2, 0.5F}),
                1e-5F);
    const std::string planar =
        "Translate 5 0 0 " +
        t("float",
          "\"bilerp\" \"string mapping\" \"planar\" \"vector3 v1\" [ 0 .5 0 ] \"vector3 "
          "v2\" [ 1 0 0 ] \"float udelta\" .125 \"float v01\" 0 \"float v10\" 1");
    EXPECT_FLOAT_EQ(value(number(planar), {5, 1, 0}), 0.625F);
}

TEST(Textures, are_made_of_textures) {
    const std::string parts =
        "Texture \"u\" \"float\" \"bilerp\" \"float v01\" 0 \"float v10\" 1 Texture \"s\" "
        "\"float\" \"scale\" \"texture tex\" \"u\" \"float scale\" 3 ";
    const Cover mix =
        number(parts + t("float",
                         "\"mix\" \"texture tex1\" \"s\" \"float tex2\" 9 \"texture amount\" "
                         "\"u\""));
    EXPECT_FLOAT_EQ(value(mix, Vec3(0), {0.25F, 0}), 0.75F * 0.75F + 0.25F * 9);
    const SpectrumTexture spectrum =
        colour(parts + t("spectrum", "\"mix\" \"rgb tex1\" [ .2 .2 .2 ] \"texture amount\" \"u\""));
    const Wavelengths wavelengths = Wavelengths::of_pass({1, 0});
    EXPECT_FLOAT_EQ(spectrum.at(at(Vec3(0), {0.5F, 0}), wavelengths)[3], 0.6F);
}

MemoryFiles two_images() {
    return {{"a/i.pfm", pfm_file("PF\n2 1\n-1\n", {1, 0, 0, 0, 0.5F, 0}, true)},
            {"grey.pfm", pfm_file("Pf\n1 1\n-1\n", {0.25F}, true)}};
}

TEST(Textures, images_are_read_once_each_from_the_main_folder) {
    const std::string image = "\"imagemap\" \"string filename\" \"a/i.pfm\" ";
    const SceneDescription scene = read_world(
        "Texture \"x\" \"spectrum\" " + image + "Texture \"y\" \"spectrum\" " + image +
            "\"string wrap\" \"clamp\" \"bool invert\" true Texture \"z\" \"spectrum\" "
            "\"imagemap\" "
            "\"string filename\" \"unused.png\" Material \"diffuse\" \"texture reflectance\" \"x\" "
            "Shape \"sphere\" Material \"diffuse\" \"texture reflectance\" \"y\" Shape \"sphere\"",
        two_images());
    const std::vector<std::string> files = {"a/i.pfm"};
    EXPECT_EQ(scene.files, files);
    EXPECT_TRUE(scene.warnings.entries().empty());
    const Wavelengths wavelengths = Wavelengths::of_pass({1, 0});
    const auto& x = std::get<DiffuseMaterial>(scene.materials.at(1)).reflectance;
    const auto& y = std::get<DiffuseMaterial>(scene.materials.at(2)).reflectance;
    const SampledSpectrum red = Spectrum::rgb_albedo({1, 0, 0}).at(wavelengths);
    const SampledSpectrum cyan = Spectrum::rgb_albedo({0, 1, 1}).at(wavelengths);
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        EXPECT_NEAR(x.at(at(Vec3(0), {0.25F, 0.5F}), wavelengths)[i], red[i], 0.01F);
        EXPECT_NEAR(y.at(at(Vec3(0), {-3, 0.5F}), wavelengths)[i], cyan[i], 0.01F);
    }
}

TEST(Textures, images_have_all_parameters) {
    const std::string image = "\"imagemap\" \"string filename\" \"grey.pfm\" ";
    const SceneDescription scene = read_world(
        t("float", image + "\"string filter\" \"EWA\" \"float maxanisotropy\" 4 \"float scale\" 2 "
                           "\"string encoding\" \"gamma 2.2\" \"float uscale\" 2 \"string wrap\" "
                           "\"octahedralsphere\"") +
            " Shape \"sphere\" \"texture alpha\" \"t\"",
        two_images());
    EXPECT_EQ(scene.warnings.entries().size(), 1U);
    EXPECT_EQ(warnings_with(scene, "not filtered by distance"), 1);
    EXPECT_FLOAT_EQ(value(scene.shapes.at(0).placed.cover, Vec3(0)), 0.5F);
}

/// A coat is one for all of a surface: images are read before they are asked for their mean.
TEST(Textures, images_on_coats_count_as_their_mean) {
    const SceneDescription scene = read_world(
        t("float", "\"imagemap\" \"string filename\" \"grey.pfm\" ") +
            "Material \"coateddiffuse\" \"texture roughness\" \"t\" \"bool remaproughness\" "
            "false\nShape \"sphere\"",
        two_images());
    EXPECT_EQ(warnings_with(scene, "the texture of \"roughness\" is replaced by its mean"), 1);
    const auto& coated = std::get<CoatedDiffuseMaterial>(scene.materials.at(1));
    ASSERT_TRUE(coated.coat->facets());
    EXPECT_FLOAT_EQ(coated.coat->facets()->alpha_x, 0.25F);
}

TEST(Textures, that_are_ptex_are_half) {
    const SceneDescription scene =
        read_world(t("spectrum", "\"ptex\" \"string filename\" \"x.ptx\"") +
                   " Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"");
    EXPECT_EQ(warnings_with(scene, "ptex"), 1);
    EXPECT_EQ(std::get<DiffuseMaterial>(scene.materials.at(1)).reflectance.curve()(500), 0.5F);
}

TEST(Textures, bend_surfaces) {
    const std::string u = "Texture \"u\" \"float\" \"bilerp\" ";
    const SceneDescription scene = read_world(
        u + "Material \"diffuse\" \"texture displacement\" \"u\" Shape \"sphere\" Material "
            "\"diffuse\" \"string normalmap\" \"a/i.pfm\" Shape \"sphere\" Material \"diffuse\" "
            "\"float displacement\" 3 Shape \"sphere\"",
        two_images());
    ASSERT_EQ(scene.bump_maps.size(), scene.materials.size());
    EXPECT_TRUE(is_flat(scene.bump_maps[0]));
    EXPECT_TRUE(std::holds_alternative<DisplacementMap>(scene.bump_maps[1]));
    EXPECT_TRUE(std::holds_alternative<NormalMap>(scene.bump_maps[2]));
    EXPECT_TRUE(is_flat(scene.bump_maps[3]));
    EXPECT_TRUE(scene.warnings.entries().empty());
}

TEST(Textures, that_cannot_be_are_errors) {
    const auto used = [](const std::string& kind, const std::string& rest) {
        return t(kind, rest) + (kind == "float" ? " Shape \"sphere\" \"texture alpha\" \"t\""
                                                : " Material \"diffuse\" \"texture reflectance\" "
                                                  "\"t\" Shape \"sphere\"");
    };
    const std::string image = "\"imagemap\" \"string filename\" \"grey.pfm\" ";
    for (const std::string& text :
         {used("colour", "\"constant\""), used("float", "\"marble\""), used("spectrum", "\"fbm\""),
          used("float", "\"imagemap\""),
          used("float", "\"imagemap\" \"string filename\" \"none.png\""),
          used("float", image + "\"string wrap\" \"round\""),
          used("float", image + "\"string filter\" \"sharp\""),
          used("float", image + "\"string encoding\" \"gamma\""),
          used("float", image + "\"string mapping\" \"conical\""),
          used("float", "\"checkerboard\" \"integer dimension\" 4"),
          used("float", "\"scale\" \"texture tex\" \"t\""),
          used("float",
               "\"scale\" \"texture tex\" \"later\" Texture \"later\" \"float\" "
               "\"constant\""),
          used("float", "\"directionmix\" \"vector3 dir\" [ 1 0 ]"),
          std::string("Material \"diffuse\" \"string normalmap\" \"none.png\" Shape \"sphere\"")}) {
        const std::string error = world_error(text, two_images());
        EXPECT_NE(error, "") << text;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

TEST(Textures, nested_without_end_are_refused) {
    std::string text = "Texture \"t0\" \"float\" \"fbm\" ";
    for (int i = 1; i < 5000; ++i)
        text += "Texture \"t" + std::to_string(i) + "\" \"float\" \"scale\" \"texture tex\" \"t" +
                std::to_string(i - 1) + "\" ";
    EXPECT_NE(world_error(text + "Shape \"sphere\" \"texture alpha\" \"t4999\"")
                  .find("nested more than 100"),
              std::string::npos);
    EXPECT_EQ(world_error(text + "Shape \"sphere\" \"texture alpha\" \"t90\""), "");
}

/// Each lookup asks for all: 2^16 are too many, though the tree is not deep.
TEST(Textures, that_ask_for_too_many_are_refused) {
    const auto chain = [](int length) {
        std::string text = "Texture \"t0\" \"float\" \"constant\"\n";
        for (int i = 1; i <= length; ++i) {
            const std::string below = "\"t" + std::to_string(i - 1) + "\"";
            text += "Texture \"t" + std::to_string(i) + "\" \"float\" \"mix\" \"texture tex1\" " +
                    below + " \"texture tex2\" " + below + "\n";
        }
        return text + "Shape \"sphere\" \"texture alpha\" \"t" + std::to_string(length) + "\"";
    };
    EXPECT_NO_THROW(read_world(chain(12)));
    try {
        read_world(chain(40));
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "more than 100000 nodes")) << error.what();
    }
}

}  // namespace
}  // namespace sunfleck::engine
