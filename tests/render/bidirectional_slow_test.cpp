// Bidirectional path tracing against path tracing where both converge: of the ratio of their
// brightness the 99% interval lies inside 1 +- the tolerance of each scene.
#include "support/reference_scenes.h"

#include <gtest/gtest.h>

#include <iostream>

namespace sunfleck {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

Estimate brightness(const Scene& scene, Integrator integrator, int rounds) {
    RenderSettings settings;
    settings.transport.max_depth = 8;
    settings.integrator = integrator;
    settings.photon.paths_per_pass = 2000;
    return Estimate::over(rounds, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        const MeanPicture picture = render_mean(scene, settings, 64);
        EXPECT_EQ(picture.statistics[Count::dropped_nonfinite], 0U);
        return luminance(picture.mean());
    });
}

class References : public ::testing::TestWithParam<ReferenceScene> {};

TEST_P(References, bdpt_agrees_with_path_tracing) {
    const Scene scene = scene_of(GetParam().text);
    const Estimate path = brightness(scene, GetParam().other, GetParam().rounds);
    const Estimate both = brightness(scene, Integrator::bdpt, GetParam().rounds);
    std::cout << both.mean / path.mean << " +- " << both.error / both.mean << ' '
              << path.error / path.mean << '\n';
    EXPECT_LT(worst_ratio(both, path), GetParam().tolerance) << both.mean / path.mean;
}

INSTANTIATE_TEST_SUITE_P(Of, References, ::testing::ValuesIn(reference_scenes()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck
