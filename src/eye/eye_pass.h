// The eye pass: camera paths end in visible points, and in light that needs no photon.
//
// In:  the scene at a pass's wavelengths. Out: visible points; emission and direct light are added
// to the pass's image.
// Owners of light: docs/method.md has the table; measurement/visible_point.h what photons bring.
#pragma once

#include "camera/pixel_window.h"
#include "eye/settings.h"
#include "measurement/pass_image.h"
#include "measurement/statistics.h"
#include "measurement/transport.h"
#include "measurement/visible_point.h"
#include "sampler/round_points.h"
#include "scene/pass_scene.h"

#include <span>
#include <vector>

namespace sunfleck {

/// Pixel i has 2^doublings[i] camera paths, each with that share of its light; one if empty.
using Doublings = std::vector<std::uint8_t>;

struct EyePass {
    const PassScene& scene;
    const TransportSettings& transport;
    const EyeSettings& settings;
    PixelWindow window;
    PassId id;
    double radius_factor = 1;  // r_p / r_0
    /// Of discs for other photons, in pixels.
    float first_radius =
        static_cast<float>(sunfleck::first_radius(settings, scene.scene.film().resolution));
    /// Of discs for indirect photons, over that.
    float indirect_reach =
        static_cast<float>(sunfleck::indirect_reach(settings, scene.scene.film().resolution));
    std::span<const std::uint8_t> doublings = {};  // Doublings
    /// Rays of each pixel's paths are added, unless empty.
    std::span<std::uint64_t> rays = {};
    DrawOfPass draw = {};
    int cells = 1;  // one pixel of each PixelCells of that side has paths
};

/// All camera paths of all pixels. The order of the points, list after list, is that of the pixels.
VisiblePointLists trace_eye_paths(const EyePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck
