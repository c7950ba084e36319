// Light tracing against another integrator: the test of a view.
#pragma once

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::testing_support {

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
