// Path trials: what they bring, over the density of their emission, is what a pass brings.
#include "planning/path_trials.h"

#include "photon_samplers/uniform_sampler.h"
#include "planning/photon_trials.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A floor below a pane of glass in the sun, and a white wall.
Scene paned_floor() {
    return scene_of(view("0 -1.5 1.5  0 0 0  0 0 1", 40, 20) +
                    "LightSource \"distant\" \"point3 from\" [.2 -.3 1] \"point3 to\" [0 0 0] "
                    "\"rgb L\" [2 2 2]\n" +
                    diffuse("0.5 0.5 0.5") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                    quad("-2 1 0  2 1 0  2 1 1  -2 1 1") + "Material \"dielectric\"\n" +
                    box({-1, -1, 1}, {1, 1, 1.1}));
}

/// Uniform trials, and trials through a guide that prefers one corner of the emission: both sum up
/// to the light of a photon pass, within four standard errors.
TEST(PathTrials, bring_what_a_pass_brings) {
    const Scene scene = paned_floor();
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport;
    const CameraPathSettings camera;
    const PixelWindow window = window_of(scene.film());
    const CameraTrial seen = view_of({pass, transport, camera, window, {1, 0}});
    const PhotonContext context{pass, transport, seen.index};
    const BlockGrid blocks = judged_blocks(window);
    std::vector<WeightedEmission> corner(1000);
    RandomStream random(1, Purpose::test, 0, 0);
    for (WeightedEmission& sample : corner)
        for (double& x : sample.point) x = 0.25 + 0.5 * random.next();
    const EmissionGuide guide = EmissionGuide::learned(corner, {0.5, 4, 0});
    ASSERT_FALSE(guide.is_identity());
    const auto light = [&](const EmissionGuide& through, std::uint32_t number) {
        constexpr std::uint32_t kPaths = 20'000;
        const PathTrials trials = try_paths(context, through, blocks, {1, 100 + number}, kPaths);
        EXPECT_EQ(trials.points.size(), kPaths);
        double sum = 0;
        for (std::size_t i = 0; i < trials.light.size(); ++i) {
            const PathLight& one = trials.light[i];
            if (i > 0) {
                EXPECT_TRUE(std::pair(trials.light[i - 1].path, trials.light[i - 1].block) <
                            std::pair(one.path, one.block));
            }
            sum += one.luminance / through.density(trials.points[one.path]) / kPaths;
        }
        return sum / static_cast<double>(window.pixels());
    };
    constexpr int kRenders = 12;
    const auto over = [&](const EmissionGuide& through) {
        return Estimate::over(kRenders,
                              [&](int i) { return light(through, static_cast<std::uint32_t>(i)); });
    };
    const LightStratum stratum{scene.light_choice(), {20'000, {}}, {}};
    const Estimate passes = Estimate::over(kRenders, [&](int i) {
        PassImage image(window.pixels(), {});
        NoState none;
        const std::vector<LightStratum> strata = {stratum};
        const PhotonPass photons{context, {2, static_cast<std::uint32_t>(i)}, strata, {}};
        UniformSampler::trace(photons, {image, nullptr}, none);
        return mean_value(luminance_of(image));
    });
    ASSERT_GT(passes.mean, 0.01);
    for (const EmissionGuide& through : {EmissionGuide(), guide}) {
        const Estimate trials = over(through);
        EXPECT_NEAR(trials.mean, passes.mean, 4 * std::hypot(trials.error, passes.error));
        EXPECT_LT(trials.error, 0.02 * trials.mean);
    }
}

}  // namespace
}  // namespace sunfleck::engine
