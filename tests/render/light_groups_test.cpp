// Aovs of lights: each light's emission, direct light and photons are in its AOV, whoever
// brings them; asking for AOVs changes nothing else.
#include "photon_samplers/samplers.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSide = 12;

/// The lights of the scene, by number of their statement.
const std::array<std::string, 5> kLights = {
    "AreaLightSource \"diffuse\" \"rgb L\" [9 8 7]\n",
    "LightSource \"infinite\" \"rgb L\" [0.9 0.2 0.1]\n",
    "LightSource \"point\" \"point3 from\" [0.3 -2 1.7] \"rgb I\" [2 2 2]\n",
    "LightSource \"infinite\" \"rgb L\" [0.1 0.2 0.9]\n",
    "LightSource \"distant\" \"point3 from\" [1 -1 2] \"rgb L\" [0.7 0.7 0.6]\n"};

/// Two panels in one attribute block; the first light, where it is, is theirs.
std::string panels(bool shine) {
    return "AttributeBegin\n" + (shine ? kLights[0] : std::string()) +
           quad("-.8 .2 1.4  .2 .2 1.4  .2 -.8 1.4  -.8 -.8 1.4") +
           quad("-.8 .9 .6  .2 .9 .6  .2 .9 .3  -.8 .9 .3") + "AttributeEnd\n";
}

/// A floor, a wall, a ball of glass, a mirror and a plate of rough metal under some of the lights.
Scene lit_by(const std::vector<std::size_t>& lights) {
    std::string text = view("0 -3.8 1  0 0 0.5  0 0 1", 34, kSide);
    const bool shine = !lights.empty() && lights[0] == 0;
    text += panels(shine);
    for (const std::size_t light : lights)
        if (light > 0) text += kLights.at(light);
    return scene_of(text + diffuse("0.6 0.6 0.6") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                    quad("-2 1 0  2 1 0  2 1 1  -2 1 1") +
                    "AttributeBegin\nMaterial \"dielectric\"\nTranslate 0.5 -0.3 0.45\n"
                    "Shape \"sphere\" \"float radius\" 0.4\nAttributeEnd\n"
                    "Material \"conductor\" \"float roughness\" 0.2\n" +
                    quad("-.9 .5 .1  -.3 .8 .1  -.3 .8 .9  -.9 .5 .9") +
                    "Material \"conductor\"\n" +
                    quad("-.9 -.8 .01  -.2 -.8 .01  -.2 -.2 .01  -.9 -.2 .01"));
}

const std::vector<std::size_t> kAll = {0, 1, 2, 3, 4};

/// Aovs 0 to 2: lights {0}, {1, 4} and {3}; light 2 is in none, or in a fourth.
LightGroups aovs_of(const Scene& scene, bool with_fourth) {
    LightGroups aovs{{"area", "far", "blue"}, "as the test says", {}};
    if (with_fourth) aovs.names.emplace_back("point");
    const std::array<std::uint8_t, 5> aov_of = {0, 1, with_fourth ? std::uint8_t{3} : kNoLightGroup,
                                                2, 1};
    for (const std::uint32_t statement : scene.stated_in())
        aovs.of_light.push_back(aov_of.at(statement));
    return aovs;
}

struct Way {
    PhotonSampler sampler;
    DirectLight direct;
};

RenderSettings settings_for(const Way& way) {
    RenderSettings settings;
    settings.photon.sampler = way.sampler;
    settings.transport.direct = way.direct;
    settings.transport.max_depth = 8;
    settings.photon.paths_per_pass = 10'000;
    settings.camera.radius_pixels = 0.5;
    settings.seed = 5;
    return settings;
}

double light_value(const PassImage& image, std::size_t aov, std::size_t i, std::size_t c) {
    return image.light_value(aov, i, c).to_double();
}

class LightGroupsOf : public ::testing::TestWithParam<Way> {};

TEST_P(LightGroupsOf, add_up_to_the_picture) {
    const Scene scene = lit_by(kAll);
    RenderSettings settings = settings_for(GetParam());
    settings.transport.light_groups = aovs_of(scene, true);
    const PassResult pass = render_pass(scene, settings, 3);
    std::array<double, 4> seen{};
    for (std::size_t i = 0; i < pass.image.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0;
            double size = 0;
            for (std::size_t aov = 0; aov < seen.size(); ++aov) {
                const double value = light_value(pass.image, aov, i, c);
                seen.at(aov) += value;
                sum += value;
                size += std::abs(value);
            }
            const double total = pass.image.value(Aov::total, i, c).to_double();
            EXPECT_NEAR(sum, total, 1e-5 * size) << i;
        }
    for (const double light : seen) EXPECT_GT(light, 1);
}

TEST_P(LightGroupsOf, change_nothing_else) {
    const Scene scene = lit_by(kAll);
    RenderSettings settings = settings_for(GetParam());
    const PassResult plain = render_pass(scene, settings, 1);
    settings.transport.light_groups = aovs_of(scene, false);
    const PassResult layered = render_pass(scene, settings, 1);
    EXPECT_EQ(layered.image.light_groups(), 3U);
    EXPECT_EQ(plain.image.light_groups(), 0U);
    EXPECT_EQ(plain.statistics, layered.statistics);
    for (std::size_t i = 0; i < plain.image.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(plain.image.value(Aov::total, i, c), layered.image.value(Aov::total, i, c));
    for (std::size_t cell = 0; cell < plain.image.photon_cells(); ++cell)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(plain.image.by_photons(cell, c), layered.image.by_photons(cell, c));
}

INSTANTIATE_TEST_SUITE_P(All, LightGroupsOf,
                         ::testing::Values(Way{PhotonSampler::random, DirectLight::sampled},
                                           Way{PhotonSampler::uniform, DirectLight::photons},
                                           Way{PhotonSampler::adaptive, DirectLight::sampled}),
                         [](const auto& way) { return std::string(name_of(way.param.sampler)); });

/// Of so many passes a piece, the mean luminance of an AOV; or of the picture.
std::vector<double> luminances(const Scene& scene, const RenderSettings& settings,
                               std::optional<std::size_t> aov) {
    constexpr std::uint32_t kPieces = 16;
    constexpr std::uint32_t kPasses = 48;
    std::vector<double> values;
    for (std::uint32_t piece = 0; piece < kPieces; ++piece) {
        double sum = 0;
        for (std::uint32_t p = piece * kPasses; p < (piece + 1) * kPasses; ++p) {
            const PassResult pass = render_pass(scene, settings, p);
            for (std::size_t i = 0; i < pass.image.pixels(); ++i)
                sum += aov ? luminance({light_value(pass.image, *aov, i, 0),
                                        light_value(pass.image, *aov, i, 1),
                                        light_value(pass.image, *aov, i, 2)})
                           : luminance(pixel_value(pass.image, i));
        }
        values.push_back(sum / (kPasses * kSide * kSide));
    }
    return values;
}

/// An AOV holds what its lights bring where there are no others, as a bidirectional path tracer
/// finds it.
TEST(LightGroups, hold_what_their_lights_bring_alone) {
    const Scene scene = lit_by({0, 1, 3});
    RenderSettings settings = settings_for({PhotonSampler::uniform, DirectLight::sampled});
    settings.camera.radius_pixels = 0.3;
    const std::vector<std::uint32_t>& stated = scene.stated_in();
    RenderSettings reference = settings;
    reference.integrator = Integrator::bdpt;
    for (const std::size_t light : {0U, 1U, 2U}) {
        settings.transport.light_groups = {{"it"}, "", {}};
        for (const std::uint32_t statement : stated)
            settings.transport.light_groups.of_light.push_back(statement == light ? 0
                                                                                  : kNoLightGroup);
        const std::size_t alone = std::array<std::size_t, 3>{0, 1, 3}.at(light);
        const Estimate aov = Estimate::of(luminances(scene, settings, 0));
        const Estimate apart = Estimate::of(luminances(lit_by({alone}), reference, {}));
        EXPECT_LT(worst_ratio(aov, apart), 0.04) << light << ": " << aov.mean << " +- " << aov.error
                                                 << " and " << apart.mean << " +- " << apart.error;
    }
}

/// By triangle of a shape, by statement; unnamed lights of scenes that no file states in none.
TEST(LightGroups, know_where_each_light_is_stated) {
    const Scene scene = lit_by(kAll);
    ASSERT_EQ(scene.light_statements().size(), 5U);
    EXPECT_EQ(scene.light_statements()[0].what, "AreaLightSource \"diffuse\"");
    EXPECT_EQ(scene.light_statements()[1].what, "LightSource \"infinite\"");
    EXPECT_GT(scene.light_statements()[1].where.line, scene.light_statements()[0].where.line);
    EXPECT_EQ(scene.stated_in(), (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 2, 3, 4}));
    SceneDescription description = read_pbrt_text(
        view("0 -3 1  0 0 0  0 0 1", 30, 4) + panels(true) + kLights[2], "test.pbrt");
    description.stated_in.clear();
    for (ShapeDescription& shape : description.shapes) shape.emission->statement = kNone;
    EXPECT_EQ(Scene(std::move(description)).stated_in(), std::vector<std::uint32_t>(5, kNone));
}

}  // namespace
}  // namespace sunfleck::engine
