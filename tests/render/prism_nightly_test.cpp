// Glass that splits colours, seen through more of it: against path tracing.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

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
