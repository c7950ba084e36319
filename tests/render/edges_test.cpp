// No light is lost where surfaces end: a closed box whose walls emit and reflect alike shows the
// same radiance everywhere, and so does anything white in it.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSide = 32;
constexpr double kRadiance = 2;  // 1 of the walls, and half of what they get

/// Walls from -1 to 1, seen from within towards a corner. @param within  more shapes.
Scene box_of_light(const std::string& within) {
    return scene_of(view("-.5 -.6 .4  1 1 -1  0 0 1", 60, kSide) + "AttributeBegin\n" +
                    "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nReverseOrientation\n" +
                    diffuse(".5 .5 .5") + box(Vec3d(-1), Vec3d(1)) + "AttributeEnd\n" + within);
}

/// Slats that are narrower than discs, and their gaps.
std::string slats() {
    std::string text = diffuse("1 1 1");
    for (int i = 0; i < 20; ++i) {
        const std::string low = std::to_string(0.05 * i - 0.3);
        const std::string high = std::to_string(0.05 * i - 0.27);
        text += quad(low + " .2 -.8  " + high + " .2 -.8  " + high + " .2 .2  " + low + " .2 .2");
    }
    return text;
}

/// A closed box on the floor, dark within, and a wall beside it.
std::string box_and_wall() {
    return diffuse("1 1 1") + box({0, .3, -1}, {.4, .7, -.5}) +
           quad("-.4 .5 -1  -.1 .5 -1  -.1 .5 -.3  -.4 .5 -.3");
}

RenderSettings settings_of(DirectLight direct, PhotonSampler sampler) {
    RenderSettings settings;
    settings.transport.direct = direct;
    settings.transport.indirect = IndirectLight::photons;
    settings.photon.sampler = sampler;
    settings.photon.paths_per_pass = 50'000;
    settings.seed = 4;
    return settings;
}

struct Shown {
    double mean = 0;
    double darkest = 0;  // of blocks of 8 x 8 pixels
    double brightest = 0;

    Shown(const Scene& scene, const RenderSettings& settings) {
        const MeanPicture picture = render_mean(scene, settings, 32);
        mean = luminance(picture.mean()) / kRadiance;
        darkest = brightest = mean;
        for (int y = 0; y < kSide; y += 8)
            for (int x = 0; x < kSide; x += 8) {
                const double block = luminance(picture.mean(x, y, x + 8, y + 8)) / kRadiance;
                darkest = std::min(darkest, block);
                brightest = std::max(brightest, block);
            }
    }
};

TEST(Edges, lose_no_light) {
    const Scene empty = box_of_light("");
    const Scene with_slats = box_of_light(slats());
    for (const PhotonSampler sampler : {PhotonSampler::uniform, PhotonSampler::adaptive})
        for (const Scene* scene : {&empty, &with_slats}) {
            const Shown shown(*scene, settings_of(DirectLight::sampled, sampler));
            EXPECT_NEAR(shown.mean, 1, 0.005);
            EXPECT_GT(shown.darkest, 0.98);
        }
    const Shown by_photons(with_slats, settings_of(DirectLight::photons, PhotonSampler::uniform));
    EXPECT_NEAR(by_photons.mean, 1, 0.005);
    EXPECT_GT(by_photons.darkest, 0.98);
}

/// Wide discs beside what stands on the floor, and is dark or lit behind.
TEST(Edges, of_sight_lose_and_gain_no_light) {
    RenderSettings settings = settings_of(DirectLight::photons, PhotonSampler::uniform);
    settings.camera.radius = 0.15;
    const Shown shown(box_of_light(box_and_wall()), settings);
    EXPECT_NEAR(shown.mean, 1, 0.005);
    EXPECT_GT(shown.darkest, 0.98);
    EXPECT_LT(shown.brightest, 1.02);
}

/// The loss that the paper's estimate has.
TEST(Edges, lose_light_without_probes) {
    RenderSettings settings = settings_of(DirectLight::sampled, PhotonSampler::uniform);
    settings.camera.edges = false;
    const Shown empty(box_of_light(""), settings);
    EXPECT_LT(empty.mean, 0.997);
    const Shown with_slats(box_of_light(slats()), settings);
    EXPECT_LT(with_slats.mean, 0.98);
    EXPECT_LT(with_slats.darkest, 0.95);
}

}  // namespace
}  // namespace sunfleck::engine
