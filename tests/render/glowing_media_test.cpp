// Media that emit, against closed forms, on every kind of path.
#include "render/media_ways.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A word with the same number at all wavelengths.
std::string flat(const std::string& word, double value) {
    const std::string number = std::to_string(value);
    return " \"spectrum " + word + "\" [200 " + number + " 900 " + number + "]";
}

std::string medium(const std::string& kind, double absorption, double scattering) {
    return "MakeNamedMedium \"fire\" \"string type\" " + kind + flat("sigma_a", absorption) +
           flat("sigma_s", scattering) + " \"float g\" 0.4";
}

/// A cube of 3^3 parts around the origin, nowhere empty.
std::string smoke(const std::string& more) {
    std::string text =
        "\"uniformgrid\" \"integer nx\" 3 \"integer ny\" 3 \"integer nz\" 3 "
        "\"point3 p0\" [-1.5 -1.5 -1.5] \"point3 p1\" [1.5 1.5 1.5] " +
        more + " \"float density\" [";
    for (int i = 0; i < 27; ++i) text += std::to_string(0.4 + i * 7 % 5 * 0.5) + " ";
    return text + "]";
}

/// A ball around the camera, of radius 1, full of the medium, whose wall reflects half of the light
/// and emits half.
std::string warm_ball(const std::string& full_of) {
    return full_of + "\nMediumInterface \"\" \"fire\"\n" + view("0 0 0  0 0 1  0 1 0", 60, 6) +
           "AreaLightSource \"diffuse\" \"spectrum L\" \"stdillum-D65\" \"float scale\" 0.5\n"
           "ReverseOrientation\n" +
           diffuse(".5 .5 .5") + "Shape \"sphere\"\n";
}

class GlowingMedia : public ::testing::TestWithParam<Way> {};

/// Where a medium and a wall have the same temperature, all that is seen is as bright.
TEST_P(GlowingMedia, cannot_be_seen_between_walls_that_are_as_warm) {
    const std::string glow = " \"spectrum Le\" \"stdillum-D65\"";
    Way way = GetParam();
    if (way.renders > 8) way.renders /= 3;
    for (const std::string& kind : {std::string("\"homogeneous\""), smoke("")}) {
        const Scene scene = scene_of(warm_ball(medium(kind, 0.7, 0.6) + glow));
        const Estimate value = brightness_by(scene, way, 40);
        EXPECT_LT(worst_ratio(value, {1, 0}), 0.05) << kind << value.mean << " +- " << value.error;
    }
}

/// A thin ball of glowing gas lights a floor as a point in its middle does: a square of side 1,
/// seen from beside the ball. The light that falls on it is that of its solid angle.
TEST_P(GlowingMedia, light_a_floor_like_a_lamp) {
    if (GetParam().integrator == Integrator::path) return;  // its flights do not stop in thin gas
    constexpr double kAbsorption = 0.004;
    constexpr double kRadiance = 1000;
    constexpr double kRadius = 0.5;
    constexpr double kHeight = 2;
    const Scene scene = scene_of(
        "LookAt 0 -3 2.1  0 0 0  0 0 1\nFilm \"rgb\" \"integer xresolution\" 4 "
        "\"integer yresolution\" 4\nCamera \"orthographic\" \"float screenwindow\" "
        "[-.5 .5 -.28673 .28673]\nWorldBegin\n" +
        medium("\"homogeneous\"", kAbsorption, 0) +
        " \"spectrum Le\" \"stdillum-D65\" \"float Lescale\" " + std::to_string(kRadiance) + "\n" +
        diffuse(".5 .5 .5") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
        "AttributeBegin\nTranslate 0 0 2\nMaterial \"interface\"\n"
        "MediumInterface \"fire\" \"\"\nShape \"sphere\" \"float radius\" 0.5\nAttributeEnd\n");
    const double intensity =
        kAbsorption * kRadiance * 4 * kPiDouble / 3 * kRadius * kRadius * kRadius;
    const double solid_angle = 4 * std::atan(0.25 / (kHeight * std::sqrt(0.5 + kHeight * kHeight)));
    const double expected = 0.5 / kPiDouble * intensity * solid_angle;
    Way way = GetParam();
    way.renders = 32;
    const Estimate value = brightness_by(scene, way, 1);
    EXPECT_LT(worst_ratio(value, {expected, 0}), 0.05)
        << value.mean / expected << " +- " << value.error / expected;
}

INSTANTIATE_TEST_SUITE_P(By, GlowingMedia, ::testing::ValuesIn(ways_through_media()),
                         [](const auto& info) { return std::string(info.param.name); });

/// What lies beyond the borders of its medium does not glow: a grid in a smaller ball.
TEST(GlowOfMedia, ends_where_shapes_end_its_medium) {
    const Scene scene = scene_of(
        view("0 -4 0  0 0 0  0 0 1", 40, 4) +
        medium(smoke("\"float Lescale\" [1 0 0 0 2 0 0 0 0 1 1 1 1 1 1 0 0 0 3 3 3 0 0 1 2 0 2]"),
               0.5, 0.1) +
        " \"spectrum Le\" \"stdillum-D65\"\n" + diffuse(".5 .5 .5") +
        quad("-2 -2 -.8  2 -2 -.8  2 2 -.8  -2 2 -.8") +
        "AttributeBegin\nMaterial \"interface\"\nMediumInterface \"fire\" \"\"\n"
        "Shape \"sphere\" \"float radius\" 0.7\nAttributeEnd\n");
    const Way path{.name = "path", .integrator = Integrator::path, .renders = 300};
    const Estimate expected = brightness_by(scene, path, 6);
    for (const Way& way :
         {Way{.name = "photons", .renders = 16},
          Way{.name = "camera", .indirect = IndirectLight::sampled, .renders = 16}}) {
        const Estimate value = brightness_by(scene, way, 6);
        EXPECT_LT(worst_ratio(value, expected), 0.06)
            << way.name << ' ' << value.mean / expected.mean << " +- " << value.error / value.mean
            << " and " << expected.error / expected.mean;
    }
}

/// The camera sees a slab of a hot medium: its black body, less what is thin.
TEST(GlowOfMedia, has_the_colour_of_its_temperature) {
    const std::string heat =
        "\"uniformgrid\" \"float density\" [8 8] \"integer nz\" 2 \"float temperature\" [20 20] "
        "\"float temperatureoffset\" 5 \"float temperaturescale\" 200 \"float Lescale\" 7 "
        "\"point3 p0\" [-900 -900 -20] \"point3 p1\" [900 900 20]";
    const Scene scene = scene_of(view("0 0 -30  0 0 0  0 1 0", 2, 4) + medium(heat, 2, 0) +
                                 "\nMaterial \"interface\"\nMediumInterface \"fire\" \"\"\n" +
                                 box({-9, -9, -10}, {9, 9, 10}));
    RenderSettings settings;
    settings.transport.max_depth = 2;
    const Vec3 seen(render_mean(scene, settings, 64).mean());
    const Vec3 expected = Spectrum(BlackbodySpectrum{3000}).to_rgb() * 7;
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(seen[i], expected[i], 0.02 * expected.x) << seen << ' ' << expected;
}

/// A slab, 2 thick, that absorbs .3 and scatters .2 per unit, before a wall in the left half of the
/// picture.
TEST(Transmittance, is_what_media_leave_from_the_first_surface_or_from_afar) {
    const Scene scene = scene_of(
        view("0 0 -30  0 0 0  0 1 0", 2, 4) + medium("\"homogeneous\"", 0.3, 0.2) +
        "\nLightSource \"infinite\"\n" + diffuse(".5 .5 .5") +
        quad("0 -5 5  5 -5 5  5 5 5  0 5 5") +
        "Material \"interface\"\nMediumInterface \"fire\" \"\"\n" + box({-9, -9, -1}, {9, 9, 1}));
    RenderSettings settings;
    settings.aovs[static_cast<std::size_t>(Aov::transmittance)] = true;
    const MeanPicture left = render_mean(scene, settings, 4, Aov::transmittance);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_NEAR(luminance(left.mean(x, y, x + 1, y + 1)), std::exp(-1.0), 0.01);
}

TEST(GlowOfMedia, needs_absorption) {
    const auto warnings_of = [](double absorption) {
        const Scene scene = scene_of(view("0 0 -3  0 0 0  0 1 0", 20, 4) +
                                     medium("\"homogeneous\"", absorption, 1) +
                                     " \"rgb Le\" [1 1 1]\nMediumInterface \"\" \"fire\"\n" +
                                     diffuse(".5 .5 .5") + "Shape \"sphere\"\n");
        std::string lines;
        for (const auto& entry : scene.warnings().entries()) lines += entry.line() + "\n";
        return lines;
    };
    EXPECT_NE(warnings_of(0).find("absorbs nothing"), std::string::npos) << warnings_of(0);
    EXPECT_EQ(warnings_of(1).find("absorbs nothing"), std::string::npos) << warnings_of(1);
}

}  // namespace
}  // namespace sunfleck::engine
