// A room under a constant sky that comes in by a hole in the ceiling: as bright whether or not the
// sky is told of the hole (a portal), and by whichever way light is brought.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// Floor, walls and a ceiling at height 1 with a square hole; seen from below the ceiling: the
/// middle of the floor. @param portal  a parameter of the sky.
Scene room(const std::string& portal) {
    return scene_of(
        view("0 0 .95  0 0 0  0 1 0", 70, 16) + "LightSource \"infinite\" " + portal +
        diffuse("0.5 0.5 0.5") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
        quad("-1 -1 0  -1 1 0  -1 1 1  -1 -1 1") + quad("1 -1 0  1 -1 1  1 1 1  1 1 0") +
        quad("-1 -1 0  -1 -1 1  1 -1 1  1 -1 0") + quad("-1 1 0  1 1 0  1 1 1  -1 1 1") +
        quad("-1 -1 1  -1 1 1  -.6 1 1  -.6 -1 1") + quad(".6 -1 1  .6 1 1  1 1 1  1 -1 1") +
        quad("-.6 -1 1  -.6 -.6 1  .6 -.6 1  .6 -1 1") +
        quad("-.6 .6 1  -.6 1 1  .6 1 1  .6 .6 1"));
}

Estimate brightness(const Scene& scene, RenderSettings settings, int renders) {
    return Estimate::over(renders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(scene, settings, 16).mean());
    });
}

/// The 99% interval of each ratio lies within 1%.
TEST(PortalRoom, is_as_bright_as_without_the_portal) {
    const Scene plain = room("");
    const Scene told = room("\"point3 portal\" [-.6 -.6 1  -.6 .6 1  .6 .6 1  .6 -.6 1]\n");
    ASSERT_TRUE(told.warnings().entries().empty()) << told.warnings().entries()[0].line();
    RenderSettings settings;
    settings.transport.max_depth = 12;
    settings.integrator = Integrator::path;
    const Estimate expected = brightness(plain, settings, 100);
    EXPECT_LT(expected.error, 0.003 * expected.mean);
    const auto expect = [&](const char* what, int renders) {
        const Estimate seen = brightness(told, settings, renders);
        EXPECT_LT(worst_ratio(seen, expected), 0.01)
            << what << ": " << seen.mean / expected.mean << ", errors " << seen.error / seen.mean
            << ' ' << expected.error / expected.mean;
    };
    expect("path", 30);
    settings.integrator = Integrator::bdpt;
    expect("bdpt", 30);
    settings.integrator = Integrator::sppm;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 10'000;
    settings.transport.direct = DirectLight::photons;
    expect("photons", 10);
    settings.transport.direct = DirectLight::sampled;
    expect("sampled", 10);
}

}  // namespace
}  // namespace sunfleck::engine
