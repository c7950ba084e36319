// Media that absorb, against closed forms: exp(-sigma d) on every kind of path.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr double kDark = 0.002;  // a floor that sends nearly nothing back to what lies over it

RenderSettings settings_for(DirectLight direct, Integrator integrator = Integrator::sppm) {
    RenderSettings settings;
    settings.integrator = integrator;
    settings.transport.direct = direct;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = direct == DirectLight::sampled ? 2'000 : 10'000;
    settings.camera.radius = 0.8;
    return settings;
}

std::string medium(const std::string& name, double sigma) {
    return "MakeNamedMedium \"" + name +
           R"(" "string type" "homogeneous" "rgb sigma_s" [0 0 0] "spectrum sigma_a" [200 )" +
           std::to_string(sigma) + " 900 " + std::to_string(sigma) + "]\n";
}

/// A surface between media that is nothing else.
std::string border(const std::string& inside, const std::string& outside,
                   const std::string& shapes) {
    return "AttributeBegin\nMaterial \"interface\"\nMediumInterface \"" + inside + "\" \"" +
           outside + "\"\n" + shapes + "AttributeEnd\n";
}

std::string floor_quad() {
    return diffuse("0.002 0.002 0.002") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0");
}

std::string sun() {
    return "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n";
}

/// A small part of the floor from straight above, by a camera at that height.
std::string from_above(double height) {
    return view("0 0 " + std::to_string(height) + "  0 0 0  0 1 0", 2, 4);
}

Estimate brightness(const Scene& scene, RenderSettings settings, int renders) {
    return Estimate::over(renders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(scene, settings, 16).mean());
    });
}

/// A sphere whose wall of albedo rho emits 1, full of a medium. Of even light from the wall, the
/// share t = 2 (1 - (1 + a) exp(-a)) / a^2 comes back to it, a = sigma * diameter: chords have
/// the length diameter * cosine. The wall shows 1 / (1 - rho t).
void expect_furnace(RenderSettings settings, int renders) {
    const double a = 2 * 0.6;
    const double back = 2 * (1 - (1 + a) * std::exp(-a)) / (a * a);
    const double expected = std::exp(-a / 2) / (1 - 0.8 * back);  // seen from the centre
    const Scene scene = scene_of(
        medium("ink", 0.6) + "MediumInterface \"\" \"ink\"\n" + view("0 0 0  0 0 1  0 1 0", 60, 6) +
        "AreaLightSource \"diffuse\" \"spectrum L\" \"stdillum-D65\"\nReverseOrientation\n" +
        diffuse("0.8 0.8 0.8") + "Shape \"sphere\"\n");
    settings.camera.radius = 0.2;
    settings.photon.paths_per_pass = 10'000;
    const Estimate value = brightness(scene, settings, renders);
    EXPECT_LT(worst_ratio(value, {expected, 0}), 0.006) << value.mean / expected;
}

class Media : public ::testing::TestWithParam<RenderSettings> {
protected:
    /// The share of the sun's light on the floor that comes to the camera.
    static void expect_share(const std::string& text, double share) {
        const Estimate value = brightness(scene_of(text), GetParam(), 8);
        const Estimate expected{kDark / kPiDouble * share, 0};
        const bool noisy = GetParam().transport.direct == DirectLight::photons;
        EXPECT_LT(worst_ratio(value, expected), noisy ? 0.003 : 0.002)
            << value.mean / expected.mean;
    }
};

TEST_P(Media, slab_between_light_and_floor) {
    expect_share(medium("ink", 1.4) + from_above(0.9) + sun() + floor_quad() +
                     border("ink", "", box({-2, -2, 1}, {2, 2, 1.5})),
                 std::exp(-0.7));
}

TEST_P(Media, pool_over_the_floor) {
    expect_share(from_above(3) + medium("ink", 0.5) + sun() + floor_quad() +
                     border("ink", "", box({-2, -2, -.1}, {2, 2, 0.8})),
                 std::exp(-0.8));
}

/// Light and camera are in the pool; the camera looks through what lies in it.
TEST_P(Media, pool_with_something_in_it_around_the_eye) {
    const std::string pool = medium("ink", 0.3) + medium("ice", 1.1);
    expect_share(pool + "MediumInterface \"\" \"ink\"\n" + from_above(1.5) +
                     "MediumInterface \"\" \"\"\n" + sun() + floor_quad() +
                     border("ink", "", box({-2, -2, -.1}, {2, 2, 2})) +
                     border("ice", "ink", box({-2, -2, 0.5}, {2, 2, 0.9})) +
                     border("", "ice", box({-2, -2, 0.6}, {2, 2, 0.7})),
                 std::exp(-0.3 * (1.6 + 1.1) - 1.1 * 2 * 0.3));
}

TEST_P(Media, furnace_that_is_full) {
    expect_furnace(GetParam(), GetParam().integrator == Integrator::path ? 100 : 8);
}

INSTANTIATE_TEST_SUITE_P(By, Media,
                         ::testing::Values(settings_for(DirectLight::sampled),
                                           settings_for(DirectLight::photons),
                                           settings_for(DirectLight::sampled, Integrator::path)),
                         [](const auto& way) {
                             if (way.param.integrator == Integrator::path) return "paths";
                             return way.param.transport.direct == DirectLight::sampled ? "sampled"
                                                                                       : "photons";
                         });

TEST(MediaLight, furnace_that_is_full) {
    expect_furnace(settings_for(DirectLight::photons, Integrator::light), 6);
}

/// A plate of glass that absorbs: T = (1 - R)^2 t / (1 - R^2 t^2), R = 0.04, t = exp(-sigma d).
/// Photons alone bring the light.
TEST(MediaPhotons, plate_of_dark_glass) {
    const Scene scene =
        scene_of(view("0 -3 1.5  0 0 0  0 0 1", 6, 8) + medium("grey", 4) + sun() + floor_quad() +
                 "MediumInterface \"grey\" \"\"\nMaterial \"dielectric\" \"float eta\" 1.5\n" +
                 box({-2, -2, 1.8}, {2, 2, 2}));
    const double t = std::exp(-0.8);
    const double expected = 0.96 * 0.96 * t / (1 - 0.04 * 0.04 * t * t) * kDark / kPiDouble;
    RenderSettings settings = settings_for(DirectLight::sampled);
    settings.photon.paths_per_pass = 10'000;
    const Estimate value = brightness(scene, settings, 24);
    EXPECT_LT(worst_ratio(value, {expected, 0}), 0.01) << value.mean / expected;
}

/// The light of a sky that is beyond endless fog never arrives, by whatever path; neither
/// does it at a camera in a bubble of clear air.
TEST(MediaPhotons, endless_fog_is_black) {
    const std::string sky =
        "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + sun() + diffuse("0.5 0.5 0.5");
    const std::string bubble =
        "AttributeBegin\nMaterial \"interface\"\nMediumInterface \"\" \"fog\"\n"
        "Shape \"sphere\" \"float radius\" 4\nAttributeEnd\n";
    const std::string ball = "Shape \"sphere\" \"float radius\" .5\n";
    const std::string fog = medium("fog", 1e-6);
    const std::string camera = view("0 0 2  0 0 0  0 1 0", 60, 8);
    for (const DirectLight direct : {DirectLight::sampled, DirectLight::photons}) {
        const auto light = [&](const std::string& text) {
            const MeanPicture picture = render_mean(scene_of(text), settings_for(direct), 4);
            return luminance(picture.mean());
        };
        EXPECT_EQ(light(fog + "MediumInterface \"fog\"\n" + camera + sky + ball), 0);
        EXPECT_EQ(light(fog + camera + bubble + sky + ball), 0);
        EXPECT_GT(light(camera + sky + ball), 0.3);
    }
}

}  // namespace
}  // namespace sunfleck::engine
