// Film, filter and hints.
#include "import/pbrt/film.h"

#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

SceneDescription with(const std::string& options) {
    return read_text(options + "\nWorldBegin");
}

TEST(Film, has_pbrts_defaults) {
    const SceneDescription scene = with("");
    EXPECT_EQ(scene.film.resolution, Vec2i(1280, 720));
    EXPECT_FALSE(scene.film.crop);
    EXPECT_EQ(scene.film.imaging_ratio, 1);
    EXPECT_EQ(scene.filter.kind, FilterKind::gaussian);
    EXPECT_EQ(scene.filter.radius, Vec2d(1.5, 1.5));
    EXPECT_FALSE(scene.hints.max_depth);
    EXPECT_TRUE(scene.warnings.entries().empty());
}

TEST(Film, whose_exposure_is_no_float_is_told_with_the_product) {
    const auto fault = [](const std::string& iso, const std::string& close) {
        return error_of("Film \"rgb\" \"float iso\" " + iso +
                        " Camera \"perspective\" \"float shutterclose\" " + close + " WorldBegin");
    };
    for (const auto& [iso, close] :
         {std::pair("3e38", "1e38"), std::pair("1e-38", "1e-38"), std::pair("1e30", "1e20")}) {
        const std::string text = fault(iso, close);
        EXPECT_TRUE(contains(text, "\"iso\"") && contains(text, "\"shutterclose\"") &&
                    contains(text, "3.4e38"))
            << iso << close << text;
    }
    EXPECT_EQ(fault("3e38", "1e-38"), "");
}

TEST(Film, is_read) {
    const SceneDescription scene = with(
        "Film \"rgb\" \"integer xresolution\" 30 \"integer yresolution\" 20 \"float "
        "cropwindow\" [ .1 .5 .25 .26 ] \"string filename\" \"a.exr\" \"float iso\" 200 "
        "\"string sensor\" \"cie1931\" \"bool savefp16\" false\n"
        "Camera \"perspective\" \"float shutteropen\" .25 \"float shutterclose\" .75");
    EXPECT_EQ(scene.film.resolution, Vec2i(30, 20));
    const std::array<int, 4> crop = {3, 15, 5, 6};
    EXPECT_EQ(*scene.film.crop, crop);
    EXPECT_EQ(scene.film.filename, "a.exr");
    EXPECT_EQ(scene.film.imaging_ratio, 1);
    EXPECT_TRUE(scene.warnings.entries().empty());
    const SceneDescription bounds = with("Film \"rgb\" \"integer pixelbounds\" [ -1 5 700 900 ]");
    const std::array<int, 4> pixels = {0, 5, 700, 720};
    EXPECT_EQ(*bounds.film.crop, pixels);
}

TEST(Film, says_what_is_approximated) {
    const SceneDescription scene = with(
        "Film \"gbuffer\" \"string sensor\" \"nikon_d850\" \"float whitebalance\" 5000 "
        "\"float scale\" 2 \"float colour\" 3");
    EXPECT_EQ(scene.warnings.entries().size(), 4U);
    EXPECT_EQ(scene.film.white, 5000);
    EXPECT_EQ(warnings_with(scene, "unused parameter \"float colour\" of Film \"gbuffer\""), 1);
}

TEST(Film, cameras_are_white_balanced_and_the_observer_only_when_asked) {
    EXPECT_EQ(with("Film \"rgb\" \"string sensor\" \"canon_eos_5d_mkiv\"").film.white, 6500);
    EXPECT_FALSE(with("Film \"rgb\"").film.white);
    EXPECT_EQ(with("Film \"rgb\" \"float whitebalance\" 3200").film.white, 3200);
    EXPECT_THROW(with("Film \"rgb\" \"string sensor\" \"box_brownie\""), Error);
}

TEST(Film, filters_have_their_own_defaults) {
    EXPECT_EQ(with("PixelFilter \"box\"").filter.radius, Vec2d(0.5, 0.5));
    EXPECT_EQ(with("PixelFilter \"triangle\"").filter.radius, Vec2d(2, 2));
    EXPECT_EQ(with("PixelFilter \"sinc\"").filter.radius, Vec2d(4, 4));
    const FilterSettings mitchell =
        with("PixelFilter \"mitchell\" \"float B\" .1 \"float C\" .2 \"float xradius\" 3").filter;
    EXPECT_EQ(mitchell.kind, FilterKind::mitchell);
    EXPECT_EQ(mitchell.radius, Vec2d(3, 2));
    EXPECT_EQ(mitchell.b, 0.1);
    EXPECT_EQ(mitchell.c, 0.2);
    EXPECT_EQ(with("PixelFilter \"gaussian\" \"float sigma\" .7").filter.sigma, 0.7);
}

TEST(Film, depth_comes_from_any_integrator) {
    const SceneDescription path = with("Integrator \"path\" \"integer maxdepth\" 17");
    EXPECT_EQ(path.hints.max_depth, 17);
    EXPECT_EQ(path.hints.integrator, "path");
    EXPECT_EQ(warnings_with(path, "integrator \"path\""), 1);
    const SceneDescription sppm = with("Integrator \"sppm\" \"integer maxdepth\" 6");
    EXPECT_EQ(sppm.hints.max_depth, 6);
    EXPECT_TRUE(sppm.warnings.entries().empty());
}

/// What is chosen by the program is told once each; a word that pbrt-v4 does not know, too.
TEST(Film, tells_what_of_integrator_sampler_and_accelerator_is_not_heeded) {
    const SceneDescription scene = with(
        "Integrator \"sppm\" \"float radius\" .05 \"integer photonsperiteration\" 1000 \"integer "
        "maxdept\" 3\nSampler \"stratified\" \"integer xsamples\" 3 \"integer ysample\" 5\n"
        "Accelerator \"bvh\" \"integer maxnodeprims\" 4 \"integer splits\" 2");
    for (const char* text :
         {"\"radius\"", "\"photonsperiteration\"", "maxdept", "ysample", "splits"})
        EXPECT_EQ(warnings_with(scene, text), 1) << text;
    EXPECT_EQ(scene.warnings.entries().size(), 5U);
}

TEST(Film, that_cannot_be_is_an_error) {
    for (const char* text :
         {"Film \"rgb\" \"integer xresolution\" 0", "Film \"rgb\" \"integer yresolution\" -5",
          "Film \"rgb\" \"integer xresolution\" 70000",
          "Film \"rgb\" \"integer xresolution\" 65536 \"integer yresolution\" 65536",
          "Film \"rgb\" \"float cropwindow\" [ .5 .5 0 1 ]",
          "Film \"rgb\" \"float cropwindow\" [ 0 1 ]",
          "Film \"rgb\" \"integer pixelbounds\" [ 0 1 ]", "Film \"rgb\" \"float iso\" 0",
          "Film \"image\"", "PixelFilter \"cone\"", "PixelFilter \"box\" \"float xradius\" 0",
          "PixelFilter \"gaussian\" \"float sigma\" 0",
          "Integrator \"path\" \"integer maxdepth\" -1",
          "Camera \"perspective\" \"float shutterclose\" 0"})
        EXPECT_NE(error_of(std::string(text) + "\nWorldBegin"), "") << text;
}

}  // namespace
}  // namespace sunfleck::engine
