// CameraPass: scene, settings, pixels and radii that the camera paths of a pass share.
#pragma once

#include "aovs/transport.h"
#include "camera/pixel_window.h"
#include "camera_paths/direct_in_media.h"
#include "camera_paths/settings.h"
#include "random_numbers/batch_points.h"
#include "scene/pass_scene.h"

#include <optional>
#include <span>
#include <vector>

namespace sunfleck::engine {

/// Pixel i has 2^log2_samples[i] camera paths of equal weight; one path if the list is empty.
using Log2Samples = std::vector<std::uint8_t>;

/// What the discs of a pixel may reach over.
enum class Edge : std::uint8_t {
    none,
    of_surface,  // no surface lies there
    of_sight     // or one that something hides: a wall, a box on the floor
};
using EdgePixels = std::vector<Edge>;

struct CameraPass {
    const PassScene& scene;
    const TransportSettings& transport;
    const CameraPathSettings& settings;
    PixelWindow window;
    PassId id;
    double radius_factor = 1;  // gather radius of this pass over that of pass 0
    /// Initial gather radius for direct and caustic photons, in pixel footprints.
    float first_radius =
        static_cast<float>(sunfleck::engine::first_radius(settings, scene.scene.film().resolution));
    /// Radius scale: gather radius for indirect photons over that for the others.
    float indirect_radius_scale = static_cast<float>(
        sunfleck::engine::indirect_radius_scale(settings, scene.scene.film().resolution));
    std::span<const std::uint8_t> log2_samples = {};  // Log2Samples
    std::span<const Edge> edges = {};  // EdgePixels; all discs are probed if it is empty
    /// Nothing: light samples bring all light that comes straight from lights to media.
    std::optional<DirectInMedia> direct_in_media = {};
    std::span<Lit> lit = {};  // by pixel, to be set; unless it is empty
    /// The rays of each pixel's paths are added here, unless it is empty.
    std::span<std::uint64_t> rays = {};
    int cells = 1;  // if above 1, only the chosen pixels of PixelCells with this side have paths
};

}  // namespace sunfleck::engine
