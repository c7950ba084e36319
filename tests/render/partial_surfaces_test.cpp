// Surfaces that are there in part are as bright by photons as by path tracing: three rows of the
// table of equivalence (partial_surfaces_nightly_test.cpp), within 5% at 99%. Light that is counted
// with the square of its probability is off by 10 to 50%.
#include "partial_surfaces.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

Estimate brightness(const Scene& scene, RenderSettings settings) {
    constexpr int kRenders = 8;
    constexpr int kPasses = 16;
    return Estimate::over(kRenders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(scene, settings, kPasses).mean());
    });
}

TEST(PartialSurfaces, are_as_bright_by_photons_as_by_path_tracing) {
    RenderSettings path;
    path.integrator = Integrator::path;
    RenderSettings photons;
    photons.photon.sampler = PhotonSampler::uniform;
    photons.photon.paths_per_pass = 20'000;
    photons.transport.direct = DirectLight::photons;
    photons.camera.radius_pixels = 1;
    const std::vector<std::string> rows = {"alpha_0.5", "white_and_mirror", "alpha_of_an_emitter"};
    std::size_t found = 0;
    for (const PartialScene& row : partial_scenes()) {
        if (std::find(rows.begin(), rows.end(), row.name) == rows.end()) continue;
        ++found;
        const Scene scene = scene_of(row.text);
        const Estimate a = brightness(scene, photons);
        const Estimate b = brightness(scene, path);
        EXPECT_LT(worst_ratio(a, b), 0.05) << row.name << ": " << a.mean / b.mean << ", errors "
                                           << a.error / a.mean << ' ' << b.error / b.mean;
    }
    EXPECT_EQ(found, rows.size());
}

}  // namespace
}  // namespace sunfleck::engine
