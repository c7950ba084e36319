// Textures, bumps and alpha in whole renders, by photons and by the reference path tracer.
#include "core/parallel.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A square larger than the view of 8 x 8 pixels from above, u and v in [0,1] over the view.
const std::string kFloor =
    R"(Shape "trianglemesh" "point3 P" [-2 -2 0  2 -2 0  2 2 0  -2 2 0]
"point2 uv" [-.5 -.5 1.5 -.5 1.5 1.5 -.5 1.5] "integer indices" [0 1 2 0 2 3]
)";

/// Looks straight down on the floor's square; x to the right.
std::string from_above(double half_width = 1) {
    return "Scale -1 1 1\n" +
           view("0 0 100  0 0 0  0 1 0", 2 * std::atan(half_width / 100) * 180 / kPiDouble, 8);
}

const std::string kSun =
    R"(LightSource "distant" "point3 from" [0 0 1] "point3 to" [0 0 0] "rgb L" [1 1 1]
)";

enum class Way { photons, sampled, path };

RenderSettings settings_for(Way way) {
    RenderSettings settings;
    settings.integrator = way == Way::path ? Integrator::path : Integrator::sppm;
    settings.transport.direct = way == Way::photons ? DirectLight::photons : DirectLight::sampled;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 20'000;
    settings.seed = 5;
    return settings;
}

class ThreeWays : public ::testing::TestWithParam<Way> {};

/// Reflectance u: column x of eight shows (x + 1/2) / 8 / pi. Checks: 0.2 and 0.6 in turn.
TEST_P(ThreeWays, diffuse_texture_shows_its_values) {
    const Scene ramp = scene_of(from_above() + kSun + R"(
Texture "t" "spectrum" "bilerp" "rgb v01" [0 0 0] "rgb v10" [1 1 1]
Material "diffuse" "texture reflectance" "t"
)" + kFloor);
    const MeanPicture picture = render_mean(ramp, settings_for(GetParam()), 32);
    for (const int x : {1, 3, 4, 6}) {
        const double expected = (x + 0.5) / 8 / kPiDouble;
        EXPECT_NEAR(luminance(picture.mean(x, 1, x + 1, 7)), expected, 0.04 * expected) << x;
    }
}

TEST_P(ThreeWays, checks_lie_where_they_should) {
    const Scene checks = scene_of(from_above() + kSun + R"(
Texture "t" "spectrum" "checkerboard" "float uscale" 2 "float vscale" 2
"rgb tex1" [.2 .2 .2] "rgb tex2" [.6 .6 .6]
Material "diffuse" "texture reflectance" "t"
)" + kFloor);
    const MeanPicture picture = render_mean(checks, settings_for(GetParam()), 16);
    const auto seen = [&](int x, int y) {
        return luminance(picture.mean(x, y, x + 2, y + 2)) * kPiDouble;
    };
    EXPECT_NEAR(seen(1, 1), 0.6, 0.02);  // the top left, v above 1/2
    EXPECT_NEAR(seen(5, 1), 0.2, 0.01);
    EXPECT_NEAR(seen(1, 5), 0.2, 0.01);
    EXPECT_NEAR(seen(5, 5), 0.6, 0.02);
}

/// Height 0.6 u is 0.3 x: light from above meets the normal (-0.3, 0, 1) at a smaller cosine.
TEST_P(ThreeWays, a_bumped_slope_is_lit_as_a_slope) {
    const Scene slope = scene_of(from_above() + kSun + R"(
Texture "t" "float" "bilerp" "float v01" 0 "float v10" .6 "float v11" .6
Material "diffuse" "rgb reflectance" [.5 .5 .5] "texture displacement" "t"
)" + kFloor);
    const MeanPicture picture = render_mean(slope, settings_for(GetParam()), 32);
    const double expected = 0.5 / kPiDouble / std::sqrt(1.09);
    EXPECT_NEAR(luminance(picture.mean(1, 1, 7, 7)), expected, 0.015 * expected);
}

/// A black sheet of alpha 1/2 in the sun's way (not in the camera's) halves the light of the floor.
TEST_P(ThreeWays, half_a_sheet_halves_the_light) {
    const Scene shaded = scene_of(from_above(0.2) + R"(
LightSource "distant" "point3 from" [4 0 4] "point3 to" [0 0 0] "rgb L" [1 1 1]
Material "diffuse" "rgb reflectance" [.5 .5 .5]
)" + kFloor + R"(
Material "diffuse" "rgb reflectance" [0 0 0]
AttributeBegin
Translate 3 0 3
Shape "trianglemesh" "point3 P" [-1 -1 0  1 -1 0  1 1 0  -1 1 0] "integer indices" [0 1 2 0 2 3]
"float alpha" .5
AttributeEnd
)");
    RenderSettings settings = settings_for(GetParam());
    if (GetParam() != Way::photons) settings.photon.paths_per_pass = 100;
    const Estimate value = Estimate::over(8, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(shaded, settings, 64).mean());
    });
    const double expected = 0.5 * 0.5 / kPiDouble / std::sqrt(2);
    EXPECT_LT(worst_ratio(value, {expected, 0}), 0.05) << value.mean / expected;
}

/// Checks of two equal colours are that colour: the same picture, bit by bit, as without a texture,
/// though every Bsdf is made where it is met.
TEST_P(ThreeWays, a_texture_of_one_value_changes_nothing) {
    const auto texture = [](const std::string& name, const std::string& kind,
                            const std::string& value) {
        return "Texture \"" + name + "\" \"" + kind + "\" \"checkerboard\" \"float uscale\" 7 \"" +
               value + " tex2\" " + "[" + (kind == "float" ? ".2" : ".7 .5 .3") + "] \"" + value +
               " tex1\" [" + (kind == "float" ? ".2" : ".7 .5 .3") + "]\n";
    };
    const std::string textures = texture("c", "spectrum", "rgb") + texture("r", "float", "float");
    const auto picture = [&](const std::string& colour, const std::string& rough) {
        const auto parameter = [](const std::string& text, const std::string& name) {
            return text.substr(0, text.find(' ') + 1) + name + "\" " +
                   text.substr(text.find(' ') + 1) + " ";
        };
        const Scene scene = scene_of(
            from_above() + kSun + textures + "Material \"diffuse\" " +
            parameter(colour, "reflectance") + kFloor + "Material \"conductor\" " +
            parameter(rough, "roughness") + parameter(colour, "reflectance") +
            "AttributeBegin Translate -.4 0 .5 Shape \"sphere\" \"float radius\" .3 "
            "AttributeEnd\n" +
            "Material \"dielectric\" " + parameter(rough, "roughness") +
            "AttributeBegin Translate .4 0 .5 Shape \"sphere\" \"float radius\" .3 AttributeEnd\n");
        return render_mean(scene, settings_for(GetParam()), 4).rgb;
    };
    EXPECT_EQ(picture("\"texture [\"c\"]", "\"texture [\"r\"]"),
              picture("\"rgb [.7 .5 .3]", "\"float [.2]"));
}

INSTANTIATE_TEST_SUITE_P(Textures, ThreeWays,
                         ::testing::Values(Way::photons, Way::sampled, Way::path),
                         [](const auto& way) {
                             return way.param == Way::photons   ? "photons"
                                    : way.param == Way::sampled ? "sampled"
                                                                : "path";
                         });

/// A lamp that is not there lights the floor as one that is, and is not seen.
TEST(UnseenLight, shines_as_a_seen_one) {
    const auto picture_of = [&](const std::string& alpha, Way way) {
        const Scene scene = scene_of(from_above() + R"(
Material "diffuse" "rgb reflectance" [.5 .5 .5]
)" + kFloor + R"(
AttributeBegin
AreaLightSource "diffuse" "rgb L" [20 20 20]
Translate 0 0 1
Scale -1 1 1
Rotate 180 1 0 0
Shape "disk" "float radius" .1 )" + alpha +
                                     "\nAttributeEnd\n");
        return render_mean(scene, settings_for(way), 48);
    };
    for (const Way way : {Way::photons, Way::sampled, Way::path}) {
        const MeanPicture seen = picture_of("", way);
        const MeanPicture unseen = picture_of("\"float alpha\" 0", way);
        const double corner = luminance(seen.mean(0, 0, 8, 2));
        EXPECT_NEAR(luminance(unseen.mean(0, 0, 8, 2)), corner, 0.03 * corner);
        if (way == Way::photons) continue;  // their discs are as wide as the bright spot
        // Under the lamp: radiance rho / pi * E, E = L A cos^4 / h^2 of a small lamp.
        double below = 0;
        for (const double x : {-0.21875, -0.15625, -0.09375, -0.03125})
            for (const double y : {-0.21875, -0.15625, -0.09375, -0.03125}) {
                const double d2 = 1 + x * x + y * y;
                below += 0.5 * 20 * 0.01 / (d2 * d2) / 16;
            }
        EXPECT_NEAR(luminance(unseen.mean(3, 3, 5, 5)), below, 0.03 * below);
    }
}

TEST(Textures, give_the_same_picture_on_any_number_of_threads) {
    const Scene scene = scene_of(from_above() + kSun + R"(
Texture "f" "float" "fbm"
Texture "d" "float" "dots" "float uscale" 5 "float vscale" 5 "float inside" .4 "float outside" 1
Texture "m" "spectrum" "marble"
Texture "r" "float" "bilerp" "float v00" .2 "float v01" .2 "float v10" .5 "float v11" .5
Material "diffuse" "texture reflectance" "m" "texture displacement" "f"
)" + kFloor + R"(
Translate 0 0 .5
Material "conductor" "texture roughness" "r"
Shape "sphere" "float radius" .4 "texture alpha" "d"
)");
    RenderSettings settings = settings_for(Way::sampled);
    settings.photon.sampler = PhotonSampler::adaptive;
    const auto picture = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        const MeanPicture mean = render_mean(scene, settings, 4);
        std::vector<Vec3d> pixels;
        pixels.reserve(64);
        for (int i = 0; i < 64; ++i) pixels.push_back(mean.at(i % 8, i / 8));
        return pixels;
    };
    EXPECT_EQ(picture(1), picture(3));
}

}  // namespace
}  // namespace sunfleck::engine
