// The ways in which light comes through media, each with as many renders as a test of 1% asks.
#pragma once

#include "support/renders.h"

#include <gtest/gtest.h>

#include <vector>

namespace sunfleck::engine::testing_support {

struct Way {
    const char* name;
    Integrator integrator = Integrator::sppm;
    DirectLight direct = DirectLight::sampled;
    IndirectLight indirect = IndirectLight::photons;
    PhotonSampler sampler = PhotonSampler::uniform;
    int renders = 8;
};

inline Estimate brightness_by(const Scene& scene, const Way& way, int max_depth) {
    RenderSettings settings;
    settings.integrator = way.integrator;
    settings.transport.direct = way.direct;
    settings.transport.indirect = way.indirect;
    settings.transport.max_depth = max_depth;
    settings.photon.sampler = way.sampler;
    settings.photon.paths_per_pass = 10'000;
    settings.camera.radius = 0.1;
    return Estimate::over(way.renders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(scene, settings, 16).mean());
    });
}

inline std::vector<Way> ways_through_media() {
    return {Way{"photons"}, Way{.name = "all_by_photons", .direct = DirectLight::photons},
            Way{.name = "camera_paths", .indirect = IndirectLight::sampled, .renders = 30},
            Way{.name = "path", .integrator = Integrator::path, .renders = 600}};
}

}  // namespace sunfleck::engine::testing_support
