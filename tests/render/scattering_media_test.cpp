// Media that scatter, against closed forms, on every kind of path.
#include "render/media_ways.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

std::string fog(double absorption, double scattering, double g) {
    const auto curve = [](const char* word, double value) {
        return std::string(" \"spectrum ") + word + "\" [200 " + std::to_string(value) + " 900 " +
               std::to_string(value) + "]";
    };
    return "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"" +
           curve("sigma_a", absorption) + curve("sigma_s", scattering) + " \"float g\" " +
           std::to_string(g) + "\nMediumInterface \"\" \"fog\"\n";
}

class ScatteringMedia : public ::testing::TestWithParam<Way> {};

/// In a black sphere whose wall emits 1, full of a medium that only scatters, every ray carries 1:
/// nothing tells where it is.
TEST_P(ScatteringMedia, that_absorb_nothing_cannot_be_seen_in_a_furnace) {
    const Scene scene = scene_of(
        fog(0, 1.5, 0.6) + view("0 0 0  0 0 1  0 1 0", 60, 6) +
        "AreaLightSource \"diffuse\" \"spectrum L\" \"stdillum-D65\"\nReverseOrientation\n" +
        diffuse("0 0 0") + "Shape \"sphere\"\n");
    const Estimate value = brightness_by(scene, GetParam(), 30);
    EXPECT_LT(worst_ratio(value, {1, 0}), 0.03) << value.mean << " +- " << value.error;
}

/// Light of a small lamp that a medium without end scatters once: quadrature along the view.
TEST_P(ScatteringMedia, light_once_scattered_is_what_quadrature_says) {
    if (GetParam().direct == DirectLight::photons) return;  // too few photons come once alone
    constexpr double kAbsorption = 0.1;
    constexpr double kScattering = 0.4;
    constexpr double kG = 0.4;
    const Scene scene =
        scene_of(fog(kAbsorption, kScattering, kG) + view("0 -3 0  0 0 0  0 0 1", 2, 4) +
                 "LightSource \"point\" \"point3 from\" [1 0 0] \"spectrum I\" \"stdillum-D65\"\n");
    double expected = 0;
    constexpr int kSteps = 200'000;
    constexpr double kFarthest = 60;
    for (int i = 0; i < kSteps; ++i) {
        const double t = (i + 0.5) * kFarthest / kSteps;
        const double d2 = (t - 3) * (t - 3) + 1;
        const double d = std::sqrt(d2);
        const double cosine = (t - 3) / d;  // of the angle by which light is bent: back to the eye
        const double bent = 1 + kG * kG + 2 * kG * cosine;
        const double phase = (1 - kG * kG) / (4 * kPiDouble * bent * std::sqrt(bent));
        expected += kScattering * phase * std::exp(-(kAbsorption + kScattering) * (t + d)) / d2 *
                    kFarthest / kSteps;
    }
    const Estimate value = brightness_by(scene, GetParam(), 1);
    EXPECT_LT(worst_ratio(value, {expected, 0}), 0.01)
        << value.mean / expected << " +- " << value.error / expected;
}

INSTANTIATE_TEST_SUITE_P(By, ScatteringMedia, ::testing::ValuesIn(ways_through_media()),
                         [](const auto& info) { return std::string(info.param.name); });

/// Nothing is lost where no surface is: the octree of chains reaches as far as the medium.
TEST(ScatteringMediaWithoutEnd, are_as_bright_by_chains_as_by_path_tracing) {
    const Scene scene = scene_of(fog(0.05, 0.3, 0.5) + view("0 -3 0  0 0 0  0 0 1", 40, 4) +
                                 "AttributeBegin\nTranslate 1 0 0\nAreaLightSource \"diffuse\"\n"
                                 "Shape \"sphere\" \"float radius\" .5\nAttributeEnd\n");
    const Way path{.name = "path", .integrator = Integrator::path, .renders = 200};
    const Way chains{.name = "chains", .sampler = PhotonSampler::adaptive, .renders = 12};
    const Estimate expected = brightness_by(scene, path, 3);
    const Estimate value = brightness_by(scene, chains, 3);
    EXPECT_LT(worst_ratio(value, expected), 0.06)
        << value.mean / expected.mean << " +- " << value.error / value.mean << " and "
        << expected.error / expected.mean;
}

}  // namespace
}  // namespace sunfleck::engine
