// Glass that splits colours: camera paths and photon paths each keep one wavelength that they
// choose by themselves, and the picture is right all the same.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr const char* kGlass = "Material \"dielectric\" \"spectrum eta\" \"glass-F11\"\n";

/// Transmission of a plate with all internal reflections, unpolarised at each boundary.
double plate(double cos_near, double eta) {
    const double cos_far = std::sqrt(1 - (1 - cos_near * cos_near) / (eta * eta));
    const double s = (cos_near - eta * cos_far) / (cos_near + eta * cos_far);
    const double p = (eta * cos_near - cos_far) / (eta * cos_near + cos_far);
    const double r = 0.5 * (s * s + p * p);
    return (1 - r) / (1 + r);
}

/// Colour of a floor in white light of irradiance one that comes aslant through a plate, seen
/// straight through two.
Vec3 expected(double cos_light, double albedo) {
    const Spectrum eta = *named_spectrum("glass-F11");
    const Spectrum white = Spectrum::d65();
    std::vector<TabulatedSpectrum::Point> points;
    for (int i = 360; i <= 830; ++i) {
        const auto nm = static_cast<float>(i);
        const auto n = static_cast<double>(eta(nm));
        const double through = plate(cos_light, n) * plate(1, n) * plate(1, n);
        const double share = cos_light * through * albedo / kPiDouble;
        points.push_back({nm, white(nm) * static_cast<float>(share)});
    }
    return Spectrum::table(points).to_rgb();
}

/// Sun falls aslant through a plate of glass onto a nearly black floor, seen straight through the
/// same plate and another one.
/// Per channel within 2% of the closed form with 99% confidence.
TEST(Prism, floor_under_one_plate_and_behind_another) {
    const double angle = 50 * kPiDouble / 180;
    const Scene scene = scene_of(
        view("0 0 3  0 0 0  0 1 0", 16, 32) +
        "LightSource \"distant\" \"point3 from\" [1.19175359 0 1] \"point3 to\" [0 0 0]\n" +
        diffuse("0.002 0.002 0.002") + quad("-.6 -.6 0  .6 -.6 0  .6 .6 0  -.6 .6 0") + kGlass +
        box({-1.2, -0.7, 0.4}, {1.2, 0.7, 0.45}) + box({-0.2, -0.2, 2.4}, {0.2, 0.2, 2.45}));
    RenderSettings settings;
    settings.photon.paths_per_pass = 30'000;
    settings.camera.radius = 0.08;
    const Vec3 colour = expected(std::cos(angle), 0.002);
    std::array<std::vector<double>, 3> ratio;
    for (int i = 0; i < 64; ++i) {
        settings.seed = static_cast<std::uint64_t>(i);
        const Vec3d mean = render_mean(scene, settings, 16).mean();
        for (int c = 0; c < 3; ++c)
            ratio.at(static_cast<std::size_t>(c))
                .push_back(mean[c] / static_cast<double>(colour[c]));
    }
    for (const auto& channel : ratio) {
        const Estimate seen = Estimate::of(channel);
        EXPECT_LT(worst_ratio(seen, {1, 0}), 0.02) << seen.mean << " +- " << seen.error;
    }
}

/// A prism of strong dispersion between a lamp and a wall, seen through another prism: each
/// channel as path tracing has it. Within 3% with 99% confidence.
TEST(Prism, prism_seen_through_a_prism) {
    const std::string wedge =
        "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0  -1 -1 .02  1 -1 .02"
        "  1 1 .9  -1 1 .9] \"integer indices\" [0 2 1 0 3 2  4 5 6 4 6 7  0 1 5 0 5 4"
        "  1 2 6 1 6 5  2 3 7 2 7 6  3 0 4 3 4 7]\n";
    const std::string strong =
        "Material \"dielectric\" \"spectrum eta\" [360 1.9 450 1.75 550 1.6 650 1.5 830 1.4]\n";
    const Scene scene = scene_of(
        view("0 -3 .8  0 0 0  0 0 1", 8, 16) + diffuse("0.3 0.3 0.3") +
        quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0") + strong + "AttributeBegin\nTranslate 0 0 .3\n" +
        wedge + "AttributeEnd\nAttributeBegin\nTranslate 0 -2 .53\nRotate 90 1 0 0\n" +
        "Scale .3 .3 .3\n" + wedge + "AttributeEnd\n" + diffuse("0 0 0") +
        "AreaLightSource \"diffuse\" \"rgb L\" [9 9 9]\nReverseOrientation\n" +
        quad("-2 -2 2  2 -2 2  2 2 2  -2 2 2"));
    RenderSettings settings;
    settings.transport.max_depth = 16;
    settings.photon.paths_per_pass = 40'000;
    settings.camera.radius = 0.05;
    const auto channels = [&](Integrator integrator, int renders) {
        settings.integrator = integrator;
        std::array<std::vector<double>, 3> values;
        for (int i = 0; i < renders; ++i) {
            settings.seed = static_cast<std::uint64_t>(i);
            const Vec3d mean = render_mean(scene, settings, 16).mean();
            for (int c = 0; c < 3; ++c) values.at(static_cast<std::size_t>(c)).push_back(mean[c]);
        }
        return values;
    };
    const auto path = channels(Integrator::path, 400);
    const auto photons = channels(Integrator::sppm, 40);
    for (std::size_t c = 0; c < 3; ++c) {
        const Estimate a = Estimate::of(photons.at(c));
        const Estimate b = Estimate::of(path.at(c));
        EXPECT_LT(worst_ratio(a, b), 0.03)
            << c << ": " << a.mean << " +- " << a.error << ", " << b.mean << " +- " << b.error;
    }
}

}  // namespace
}  // namespace sunfleck::engine
