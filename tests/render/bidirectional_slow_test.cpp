// The reference integrators against each other where they converge: of the ratio of their
// brightness the 99% interval lies inside 1 +- the tolerance of each scene.
#include "support/reference_scenes.h"

#include <gtest/gtest.h>

#include <iostream>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

Estimate brightness(const Scene& scene, Integrator integrator, int renders, std::uint32_t passes) {
    RenderSettings settings;
    settings.transport.max_depth = 8;
    settings.integrator = integrator;
    settings.photon.paths_per_pass = 2000;
    return Estimate::over(renders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        const MeanPicture picture = render_mean(scene, settings, passes);
        EXPECT_EQ(picture.statistics[Count::dropped_nonfinite], 0U);
        return luminance(picture.mean());
    });
}

class References : public ::testing::TestWithParam<ReferenceScene> {};

TEST_P(References, agree) {
    const Scene scene = scene_of(GetParam().text);
    const Estimate expected = brightness(scene, GetParam().other, GetParam().batches, 64);
    const auto expect = [&](const char* what, const Estimate& value) {
        std::cout << what << ' ' << value.mean / expected.mean << " +- " << value.error / value.mean
                  << ' ' << expected.error / expected.mean << '\n';
        EXPECT_LT(worst_ratio(value, expected), GetParam().tolerance)
            << what << ": " << value.mean / expected.mean;
    };
    expect("bdpt", brightness(scene, Integrator::bdpt, GetParam().batches, 64));
    // A pass is of 2048 pairs and as many chains' steps again and again, however small the picture.
    if (GetParam().by_chains) expect("mlt", brightness(scene, Integrator::mlt, 48, 4));
}

INSTANTIATE_TEST_SUITE_P(Of, References, ::testing::ValuesIn(reference_scenes()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck::engine
