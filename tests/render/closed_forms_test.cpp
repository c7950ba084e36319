// Pictures whose values are known in closed form, by both ways of bringing direct light.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

const Vec3d kOne(1);

RenderSettings settings_for(DirectLight direct) {
    RenderSettings settings;
    settings.transport.direct = direct;
    settings.photon.sampler = PhotonSampler::uniform;  // stratified
    settings.photon.paths_per_pass = 50'000;
    settings.camera.radius_pixels = 2;
    settings.seed = 11;
    return settings;
}

/// Normals inside.
std::string room() {
    return "ReverseOrientation\n" + box(-kOne, kOne);
}

class BothWays : public ::testing::TestWithParam<DirectLight> {};

/// A floor of albedo 0.5 under a point light: radiance = rho / pi * I cos(theta) / d^2.
TEST_P(BothWays, inverse_square_and_cosine) {
    const Scene scene =
        scene_of(view("0 0 4  0 0 0  0 1 0", 20, 16) +
                 "LightSource \"point\" \"point3 from\" [0 0 2] \"rgb I\" [8 8 8]\n" +
                 diffuse("0.5 0.5 0.5") + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0"));
    const MeanPicture picture = render_mean(scene, settings_for(GetParam()), 64);
    const double half = 4 * std::tan(10 * kPiDouble / 180);
    for (const int x : {1, 4, 7, 11, 14}) {
        const double px = ((x + 0.5) / 8 - 1) * half;
        const double py = (8.5 / 8 - 1) * half;
        const double d2 = px * px + py * py + 4;
        const double expected = 0.5 / kPiDouble * 8 * (2 / std::sqrt(d2)) / d2;
        // About 20,000 photons a pixel, stratified: 4 standard errors are below 2%.
        EXPECT_NEAR(luminance(picture.at(x, 8)), expected, 0.02 * expected) << x;
    }
}

/// Inside a closed box of albedo rho whose walls emit Le, radiance is Le / (1 - rho) everywhere.
TEST_P(BothWays, furnace_box) {
    const Scene scene = scene_of(view("0 0 -0.9  0 0.1 1  0 1 0", 70, 12) +
                                 "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                                 diffuse("0.5 0.5 0.5") + room());
    const MeanPicture picture = render_mean(scene, settings_for(GetParam()), 16);
    // Away from the edges of the box. Seen: 0.5%.
    EXPECT_NEAR(luminance(picture.mean(4, 4, 8, 8)), 2, 0.01);
}

/// A closed box in the sun is black inside.
TEST_P(BothWays, no_light_in_a_closed_box) {
    const Scene scene = scene_of(view("0 0 -0.9  0 0.1 1  0 1 0", 70, 12) + R"(
LightSource "distant" "point3 from" [1 2 3] "point3 to" [0 0 0] "float scale" 1000
LightSource "infinite" "rgb L" [5 5 5]
)" + diffuse("0.5 0.5 0.5") + room());
    const MeanPicture picture = render_mean(scene, settings_for(GetParam()), 8);
    EXPECT_EQ(picture.mean(), Vec3d(0));
    EXPECT_GT(picture.statistics[Count::photon_rays], 100'000U);
}

/// An emitter shines from the side of its normal alone, to the camera and to a floor.
TEST_P(BothWays, emitters_are_one_sided) {
    const auto picture_of = [&](const std::string& orientation) {
        const Scene scene = scene_of(view("0 0 3  0 0 0  0 1 0", 60, 8) + diffuse("0.5 0.5 0.5") +
                                     quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                                     "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                                     orientation + quad("-.3 -.3 1  .3 -.3 1  .3 .3 1  -.3 .3 1"));
        return render_mean(scene, settings_for(GetParam()), 16);
    };
    const MeanPicture up = picture_of("");  // the camera sees the lamp, the floor gets nothing
    EXPECT_NEAR(luminance(up.at(3, 3)), 1, 1e-3);
    EXPECT_EQ(luminance(up.at(0, 0)), 0);
    const MeanPicture down = picture_of("ReverseOrientation\n");
    EXPECT_GT(luminance(down.at(0, 0)), 1e-3);
    EXPECT_LT(luminance(down.at(3, 3)), 0.1);  // the dark back, and what light comes round to it
}

INSTANTIATE_TEST_SUITE_P(Direct, BothWays,
                         ::testing::Values(DirectLight::sampled, DirectLight::photons),
                         [](const auto& way) {
                             return way.param == DirectLight::sampled ? "sampled" : "photons";
                         });

/// A distant light of irradiance 1 on an albedo of 0.002, through a plane-parallel plate of glass:
/// photons alone can bring it. Transmission at normal incidence, all internal reflections:
/// T = (1 - R) / (1 + R), R = 0.04.
TEST(ClosedForms, plate_of_glass) {
    const Scene scene =
        scene_of(view("0 -3 1.5  0 0 0  0 0 1", 6, 8) +
                 "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n" +
                 diffuse("0.002 0.002 0.002") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                 "Material \"dielectric\" \"float eta\" 1.5\n" + box({-2, -2, 1.8}, {2, 2, 2}));
    RenderSettings settings = settings_for(DirectLight::sampled);
    settings.photon.paths_per_pass = 30'000;
    settings.camera.radius = 0.8;
    const Estimate value = Estimate::over(16, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(scene, settings, 16).mean());
    });
    // The floor is nearly black: what the plate sends back to it is below 0.04% of the light.
    const double expected = (1 - 0.04) / (1 + 0.04) * 0.002 / kPiDouble;
    EXPECT_LT(worst_ratio(value, {expected, 0}), 0.002) << value.mean / expected;
}

}  // namespace
}  // namespace sunfleck::engine
