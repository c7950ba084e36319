// Light tracing against another integrator: the test of a view.
#pragma once

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::testing_support {

inline const std::string kLamp = "AreaLightSource \"diffuse\" \"rgb L\" [10 9 7]\n" +
                                 diffuse("0 0 0") + "ReverseOrientation\n" +
                                 quad("-.4 -.6 1.9  .4 -.6 1.9  .4 .2 1.9  -.4 .2 1.9");

inline std::string room_with_metal() {
    return diffuse("0.6 0.5 0.4") + quad("-1 1 0  1 1 0  1 1 2  -1 1 2") +
           quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") + diffuse("0.6 0.1 0.1") +
           quad("-1 -1 0  -1 1 0  -1 1 2  -1 -1 2") +
           "Material \"conductor\" \"float roughness\" 0.4 \"bool remaproughness\" false\n" +
           box({0.2, 0, 0}, {0.9, 0.7, 0.6});
}

struct LightTracingEffort {
    int renders;
    double tolerance = 0.005;
};

/// The 99% interval of the ratio of their brightness lies inside 1 +- the tolerance. Renders in
/// pairs of one seed: camera rays to emitters are the same in both.
inline void expect_equal(const Scene& scene, Integrator other, const LightTracingEffort& effort) {
    RenderSettings settings;
    settings.transport.max_depth = 12;
    settings.photon.paths_per_pass = 20'000;
    settings.camera.radius_pixels = 0.5;
    const Estimate ratio = Estimate::over(effort.renders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        settings.integrator = Integrator::light;
        const double light = luminance(render_mean(scene, settings, 16).mean());
        settings.integrator = other;
        return light / luminance(render_mean(scene, settings, 16).mean());
    });
    EXPECT_LT(std::abs(ratio.mean - 1) + 2.58 * ratio.error, effort.tolerance)
        << ratio.mean << " +- " << ratio.error;
}

}  // namespace sunfleck::engine::testing_support
