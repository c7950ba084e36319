// What the camera paths of a pass share: scene, settings, pixels and radii.
#pragma once

#include "aovs/transport.h"
#include "camera/pixel_window.h"
#include "camera_paths/settings.h"
#include "random_numbers/batch_points.h"
#include "scene/pass_scene.h"

#include <span>
#include <vector>

namespace sunfleck::engine {

/// Pixel i has 2^log2_samples[i] camera paths, each with that share of its light; one if empty.
using Log2Samples = std::vector<std::uint8_t>;

struct CameraPass {
    const PassScene& scene;
    const TransportSettings& transport;
    const CameraPathSettings& settings;
    PixelWindow window;
    PassId id;
    double radius_factor = 1;  // r_p / r_0
    /// Of discs for other photons, in pixels.
    float first_radius =
        static_cast<float>(sunfleck::engine::first_radius(settings, scene.scene.film().resolution));
    /// Of discs for indirect photons, over that.
    float indirect_radius_scale = static_cast<float>(
        sunfleck::engine::indirect_radius_scale(settings, scene.scene.film().resolution));
    std::span<const std::uint8_t> log2_samples = {};  // Log2Samples
    /// Rays of each pixel's paths are added, unless empty.
    std::span<std::uint64_t> rays = {};
    Subpass subpass = {};
    int cells = 1;  // one pixel of each PixelCells of that side has paths
};

}  // namespace sunfleck::engine
