// Photon mapping against path tracing where both converge: the test of a view.
#pragma once

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::testing_support {

inline constexpr int kSize = 40;

/// Brightness over independent renders of a batch each.
inline Estimate brightness(const Scene& scene, RenderSettings settings, int renders) {
    return Estimate::over(renders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        const MeanPicture picture = render_mean(scene, settings, 16);
        EXPECT_EQ(picture.statistics[Count::dropped_nonfinite], 0U);
        return luminance(picture.mean());
    });
}

struct Effort {
    int path_renders;
    int sampled_renders;
    int photon_renders;
    double sampled_tolerance = 0.005;
    double photon_tolerance = 0.005;
};

/// The 99% interval of the ratio of their brightness lies inside the tolerance.
inline void expect_equivalent(const Scene& scene, const Effort& effort) {
    RenderSettings settings;
    settings.transport.max_depth = 12;
    settings.integrator = Integrator::path;
    const Estimate path = brightness(scene, settings, effort.path_renders);
    const auto expect = [&](const char* what, int renders, double tolerance) {
        const Estimate photons = brightness(scene, settings, renders);
        EXPECT_LT(worst_ratio(photons, path), tolerance)
            << what << ": " << photons.mean / path.mean << ", errors "
            << photons.error / photons.mean << ' ' << path.error / path.mean;
    };
    settings.integrator = Integrator::sppm;
    settings.camera.radius_pixels = 1;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 40'000;
    settings.transport.direct = DirectLight::sampled;
    expect("sampled", effort.sampled_renders, effort.sampled_tolerance);
    settings.transport.indirect = IndirectLight::sampled;
    expect("indirect light sampled", effort.sampled_renders, effort.sampled_tolerance);
    settings.transport.indirect = IndirectLight::photons;
    settings.transport.direct = DirectLight::photons;
    expect("photons", effort.photon_renders, effort.photon_tolerance);
}

}  // namespace sunfleck::engine::testing_support
