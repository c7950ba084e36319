// Spectra of parameters: scale, names, files, and numbers that no spectrum has.
#include "import/pbrt/spectra.h"

#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

Spectrum reflectance_of(const std::string& parameter, const MemoryFiles& files = {}) {
    const SceneDescription scene =
        read_world("Material \"diffuse\" " + parameter + " Shape \"sphere\"", files);
    return std::get<DiffuseMaterial>(scene.materials.at(scene.shapes.at(0).material))
        .reflectance.curve();
}

Spectrum emission_by(const std::string& parameter) {
    const SceneDescription scene = read_world("LightSource \"infinite\" " + parameter);
    return curve(scene.lights.at(0));
}

std::string reflectance_error(const std::string& parameter, const MemoryFiles& files = {}) {
    return world_error("Material \"diffuse\" " + parameter, files);
}

TEST(Spectra, rgb_of_a_surface_is_its_colour) {
    const Spectrum grey = reflectance_of("\"rgb reflectance\" [ .3 .3 .3 ]");
    EXPECT_TRUE(grey.is_constant());
    EXPECT_FLOAT_EQ(grey(500), 0.3F);
    const Spectrum red = reflectance_of("\"rgb reflectance\" [ .8 .1 .1 ]");
    EXPECT_GT(red(650), 0.7F);
    EXPECT_LT(red(480), 0.2F);
}

TEST(Spectra, rgb_of_a_light_goes_straight_through) {
    EXPECT_TRUE(emission_by("\"rgb L\" [ 3 2 1 ]").to_rgb().equalWithAbsError({3, 2, 1}, 2e-3F));
    EXPECT_TRUE(emission_by("").to_rgb().equalWithAbsError({1, 1, 1}, 2e-3F));
}

TEST(Spectra, other_spectra_of_a_light_have_luminance_one) {
    for (const char* parameter :
         {"\"blackbody L\" 3000", "\"spectrum L\" [ 300 1 900 1 ]", "\"spectrum L\" [300 7 900 9]",
          "\"spectrum L\" \"stdillum-A\"", "\"spectrum L\" \"metal-Cu-eta\""})
        EXPECT_NEAR(emission_by(parameter).luminance(), 1, 1e-5) << parameter;
    // Measured with pbrt-v4: a plane of reflectance 0.5, E = 1.
    const Vec3 warm = emission_by("\"blackbody L\" 3000").to_rgb() * (0.5F / kPi);
    EXPECT_TRUE(warm.equalWithAbsError({0.2818F, 0.1344F, 0.0433F}, 5e-4F)) << warm;
    const Vec3 equal = emission_by("\"spectrum L\" [ 300 1 900 1 ]").to_rgb() * (0.5F / kPi);
    EXPECT_TRUE(equal.equalWithAbsError({0.1918F, 0.1509F, 0.1447F}, 5e-4F)) << equal;
}

TEST(Spectra, of_a_light_that_is_dark_is_said) {
    const SceneDescription scene =
        read_world("LightSource \"infinite\" \"spectrum L\" [ 900 1 1000 1 ]");
    EXPECT_EQ(curve(scene.lights.at(0))(550), 0);
    EXPECT_EQ(warnings_with(scene, "nothing visible"), 1);
}

TEST(Spectra, are_sampled_named_or_in_a_file) {
    const Spectrum ramp = reflectance_of("\"spectrum reflectance\" [ 400 0 600 1 ]");
    EXPECT_FLOAT_EQ(ramp(500), 0.5F);
    EXPECT_EQ(ramp(601), 0);
    const MemoryFiles files = {{"ramp.spd", "# nm value\n400 0\n600 1 # end"}};
    EXPECT_FLOAT_EQ(reflectance_of("\"spectrum reflectance\" \"ramp.spd\"", files)(500), 0.5F);
    EXPECT_EQ(reflectance_of("\"spectrum reflectance\" [ \"metal-Au-eta\" ]")(500),
              (*named_spectrum("metal-Au-eta"))(500));
}

SceneDescription surface(const std::string& material, const MemoryFiles& files = {}) {
    return read_world("Material " + material + " Shape \"sphere\"", files);
}

TEST(Spectra, without_visible_points_are_told) {
    const MemoryFiles files = {{"a.spd", "0.4 .2\n0.7 .3"}, {"b.spd", "900 .2 1000 .3"}};
    const std::string diffuse = "\"diffuse\" \"spectrum reflectance\" ";
    const SceneDescription micro = surface(diffuse + "\"a.spd\"", files);
    EXPECT_EQ(warnings_with(micro, "are its wavelengths micrometres?"), 1);
    EXPECT_EQ(micro.warnings.entries()[0].where.text(), "main.pbrt:2:20");
    EXPECT_TRUE(contains(micro.warnings.entries()[0].text, "a.spd"));
    const SceneDescription infrared = surface(diffuse + "\"b.spd\"", files);
    EXPECT_EQ(warnings_with(infrared, "no point within 360 to 830 nm"), 1);
    EXPECT_EQ(warnings_with(infrared, "micrometres"), 0);
    EXPECT_EQ(warnings_with(surface(diffuse + "[ .4 .5 .7 .5 ]"), "micrometres"), 1);
    EXPECT_TRUE(surface(diffuse + "[ 300 .5 900 .5 ]").warnings.entries().empty());
}

TEST(Spectra, of_surfaces_above_one_are_told_and_cut_off) {
    const SceneDescription slightly = surface("\"diffuse\" \"rgb reflectance\" [ .1 .2 1.01 ]");
    EXPECT_EQ(warnings_with(slightly, "what is above 1 is cut off"), 1);
    EXPECT_EQ(warnings_with(slightly, "percentages"), 0);
    for (const char* parameter :
         {"\"rgb reflectance\" [ 60 40 20 ]", "\"spectrum reflectance\" [ 400 60 700 20 ]"}) {
        const SceneDescription scene = surface(std::string("\"diffuse\" ") + parameter);
        EXPECT_EQ(warnings_with(scene, "goes up to 60"), 1) << parameter;
        EXPECT_EQ(warnings_with(scene, "are these percentages?"), 1) << parameter;
    }
    EXPECT_TRUE(surface("\"conductor\" \"spectrum k\" [ 300 7 900 9 ]").warnings.entries().empty());
    EXPECT_TRUE(surface("\"diffuse\" \"rgb reflectance\" [ 1 1 1 ]").warnings.entries().empty());
}

TEST(Spectra, of_eta_and_k_go_on_beyond_their_tables) {
    const MemoryFiles files = {{"a.spd", "0.4 1.53\n0.7 1.51"}, {"b.spd", "500 1.5\n600 1.4"}};
    const auto eta = [](const SceneDescription& scene) {
        return std::get<DielectricMaterial>(scene.materials.at(scene.shapes.at(0).material)).eta;
    };
    const SceneDescription glass = surface("\"dielectric\" \"spectrum eta\" \"b.spd\"", files);
    EXPECT_FLOAT_EQ(eta(glass)(400), 1.5F);
    EXPECT_FLOAT_EQ(eta(glass)(550), 1.45F);
    EXPECT_FLOAT_EQ(eta(glass)(800), 1.4F);
    EXPECT_EQ(warnings_with(glass, "beyond, its end values go on"), 1);
    const SceneDescription micro = surface("\"dielectric\" \"spectrum eta\" \"a.spd\"", files);
    EXPECT_FLOAT_EQ(eta(micro)(550), 1.51F);
    EXPECT_EQ(warnings_with(micro, "micrometres"), 1);
    const SceneDescription metal =
        surface("\"conductor\" \"spectrum eta\" [ 500 1 600 2 ] \"spectrum k\" [ 300 1 900 3 ]");
    EXPECT_EQ(warnings_with(metal, "end values"), 1);
    EXPECT_TRUE(surface("\"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" "
                        "\"metal-Au-k\"")
                    .warnings.entries()
                    .empty());
}

TEST(Spectra, with_numbers_that_none_has_are_errors) {
    for (const char* parameter :
         {"\"rgb reflectance\" [ .1 .2 -.1 ]", "\"rgb reflectance\" []",
          "\"rgb reflectance\" [ 0 0 0 0 0 0 ]", "\"blackbody reflectance\" 0",
          "\"spectrum reflectance\" []", "\"spectrum reflectance\" [ 400 ]",
          "\"spectrum reflectance\" [ 500 1 400 1 ]", "\"spectrum reflectance\" [ 400 1 400 2 ]",
          "\"spectrum reflectance\" [ 400 -1 ]", "\"spectrum reflectance\" [ \"a\" \"b\" ]",
          "\"spectrum reflectance\" [ \"metal-Cu-k\" 1 ]", "\"float reflectance\" .5",
          "\"spectrum reflectance\" \"nowhere.spd\""})
        EXPECT_NE(reflectance_error(parameter), "") << parameter;
    EXPECT_NE(reflectance_error("\"spectrum reflectance\" \"a.spd\"", {{"a.spd", "1 2 3"}}), "");
    EXPECT_NE(reflectance_error("\"spectrum reflectance\" \"a.spd\"", {{"a.spd", ""}}), "");
    EXPECT_TRUE(contains(
        reflectance_error("\"spectrum reflectance\" \"a.spd\"", {{"a.spd", "400 1\n500 x"}}),
        "a.spd:2:5: "));
    EXPECT_TRUE(contains(reflectance_error("\"spectrum reflectance\" \"metal-Au-etta\""),
                         "did you mean \"metal-Au-eta\"?"));
}

}  // namespace
}  // namespace sunfleck::engine
