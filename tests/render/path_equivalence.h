// Photon mapping against path tracing where both converge: the test of a view.
#pragma once

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::testing_support {

inline constexpr int kSize = 40;

/// A room with coloured walls, open to one side, with an area light and a block.
inline Scene diffuse_room(const std::string& look, double fov) {
    return scene_of(view(look, fov, kSize) + diffuse("0.6 0.6 0.6") +
                    quad("-1 1 0  1 1 0  1 1 2  -1 1 2") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
                    quad("-1 -1 2  -1 1 2  1 1 2  1 -1 2") + diffuse("0.6 0.1 0.1") +
                    quad("-1 -1 0  -1 1 0  -1 1 2  -1 -1 2") + diffuse("0.1 0.5 0.1") +
                    quad("1 -1 0  1 -1 2  1 1 2  1 1 0") + diffuse("0.6 0.6 0.6") +
                    box({0.2, 0, 0}, {0.9, 0.7, 0.6}) +
                    "AreaLightSource \"diffuse\" \"rgb L\" [10 9 7]\nReverseOrientation\n" +
                    quad("-.4 -.6 1.9  .4 -.6 1.9  .4 .2 1.9  -.4 .2 1.9"));
}

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
    int sampled_renders;  // none: no light is sampled that photons do not bring
    int photon_renders;
    double sampled_tolerance = 0.005;
    double photon_tolerance = 0.005;
};

/// Uniform photons, in discs of a pixel's width.
inline RenderSettings equivalence_settings(DirectLight direct, IndirectLight indirect) {
    RenderSettings settings;
    settings.transport.max_depth = 12;
    settings.camera.radius_pixels = 1;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 40'000;
    settings.transport.direct = direct;
    settings.transport.indirect = indirect;
    return settings;
}

/// The 99% interval of the ratio of their brightness lies inside the tolerance. A render by path
/// tracing takes a tenth of the time of one by photons: so many of these that their noise is the
/// lesser part, and so many by photons that the interval is half as wide as what is allowed.
inline void expect_equivalent(const Scene& scene, const Effort& effort) {
    RenderSettings path_settings;
    path_settings.transport.max_depth = 12;
    path_settings.integrator = Integrator::path;
    const Estimate path = brightness(scene, path_settings, effort.path_renders);
    const auto expect = [&](const char* what, DirectLight direct, IndirectLight indirect,
                            int renders, double tolerance) {
        const Estimate photons = brightness(scene, equivalence_settings(direct, indirect), renders);
        EXPECT_LT(worst_ratio(photons, path), tolerance)
            << what << ": " << photons.mean / path.mean << ", errors "
            << photons.error / photons.mean << ' ' << path.error / path.mean;
    };
    if (effort.sampled_renders > 0) {
        expect("sampled", DirectLight::sampled, IndirectLight::photons, effort.sampled_renders,
               effort.sampled_tolerance);
        expect("indirect light sampled", DirectLight::sampled, IndirectLight::sampled,
               effort.sampled_renders, effort.sampled_tolerance);
    }
    expect("photons", DirectLight::photons, IndirectLight::photons, effort.photon_renders,
           effort.photon_tolerance);
}

/// Rough metal and a slab of rough glass on a floor, under a lamp and a constant sky.
inline Scene rough_objects(const std::string& look, double fov) {
    return scene_of(
        view(look, fov, kSize) + "LightSource \"infinite\" \"rgb L\" [0.5 0.6 0.7]\n" +
        diffuse("0.5 0.5 0.5") + quad("-1.6 -1.6 0  1.6 -1.6 0  1.6 1.6 0  -1.6 1.6 0") +
        "Material \"conductor\" \"float roughness\" 0.5 \"bool remaproughness\" false\n" +
        quad("-1.6 .6 0  -.1 .6 0  -.1 1 1.7  -1.6 1 1.7") +
        "Material \"dielectric\" \"float roughness\" 0.6 \"bool remaproughness\" false\n" +
        box({0.1, -0.7, 0.3}, {1.1, 0.5, 0.5}) +
        "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\nReverseOrientation\n" +
        diffuse("0.5 0.5 0.5") + quad("-.8 -.8 1.9  .8 -.8 1.9  .8 .8 1.9  -.8 .8 1.9"));
}

}  // namespace sunfleck::engine::testing_support
