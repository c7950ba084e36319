// Settings of camera paths and their visible points.
// Equations: docs/method/method.md, eqs. (5) and (6).
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunfleck::engine {

struct CameraPathSettings {
    std::optional<double> radius_pixels{};    // initial radius over the pixel footprint at the
                                              // visible point; see first_radius()
    std::optional<double> radius;             // in place of that: initial radius in scene units
    std::optional<double> indirect_radius{};  // of discs for indirect photons, over that for
                                              // others; 1 or more; see indirect_radius_scale()
    bool edges = true;  // discs are probed for edges of surfaces; see edge_probes.h
    bool ris = true;    // several light samples per vertex, or one picked from several
};

/// Returns (side / other)^(5/8), where the side is the square root of the number of pixels. Pixels
/// of small pictures get more photons each, so their noise is small and a blur would cost more. In
/// large pictures a pixel is a shorter length of the scene, so a radius of more pixels blurs no
/// more (docs/develop/decisions.md).
/// @param other  side in pixels.
inline double size_power(const Vec2i& resolution, double other) {
    const double side = std::sqrt(double(resolution.x) * resolution.y) / other;
    return std::sqrt(side) * std::sqrt(std::sqrt(std::sqrt(side)));  // exact roots
}

/// Returns the initial gather radius for direct and caustic photons, in pixels. By default it is 2
/// for sides of 512 pixels or more; for smaller ones it scales with the 5/8th power of the side,
/// but is at least 1.
inline double first_radius(const CameraPathSettings& settings, const Vec2i& resolution) {
    return settings.radius_pixels.value_or(std::clamp(2 * size_power(resolution, 512), 1.0, 2.0));
}

/// Returns the gather radius of indirect photons over that of the others. By default it is 2 if the
/// user sets a radius. Otherwise it is 2 for a side of 256 pixels and scales with the 5/8th power
/// of the side, at least 1, such that the disc is as wide as for first_radius() = 2. Indirect light
/// has few edges, whose width depends on the scene, so the best radius grows with the noise, of
/// which large pictures have less.
inline double indirect_radius_scale(const CameraPathSettings& settings, const Vec2i& resolution) {
    const double reach = std::max(1.0, 2 * size_power(resolution, 256));
    const bool is_given = settings.radius || settings.radius_pixels;
    return settings.indirect_radius.value_or(is_given ? reach
                                                      : 2 * reach / first_radius({}, resolution));
}

}  // namespace sunfleck::engine
