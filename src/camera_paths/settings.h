// What a user may choose about camera paths and their visible points.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunfleck::engine {

struct CameraPathSettings {
    std::optional<double> radius_pixels{};    // first radius over the pixel's footprint at the
                                              // visible point; see first_radius()
    std::optional<double> radius;             // instead: first radius in scene units
    std::optional<double> indirect_radius{};  // of discs for indirect photons, over that for
                                              // others; 1 or more; see indirect_radius_scale()
    bool ris = true;  // light samples of a vertex are several, or picked from several
};

/// The 5/8th power of a picture's side (the root of its number of pixels), over that of another.
/// Pixels of small pictures get more photons each and have little noise to lose by blurring; in
/// large ones a pixel is a shorter length of the scene, so that more of them blur no more
/// (docs/develop/decisions.md).
/// @param other  side, pixels.
inline double size_power(const Vec2i& resolution, double other) {
    const double side = std::sqrt(double(resolution.x) * resolution.y) / other;
    return std::sqrt(side) * std::sqrt(std::sqrt(std::sqrt(side)));  // exact roots
}

/// Of discs for direct photons and caustics, in pixels. Unless the user says, 2 in a picture of 512
/// pixels a side or more, in smaller ones as the 5/8th power of the side, but never less than 1.
inline double first_radius(const CameraPathSettings& settings, const Vec2i& resolution) {
    return settings.radius_pixels.value_or(std::clamp(2 * size_power(resolution, 512), 1.0, 2.0));
}

/// Of discs for indirect photons, over the radius for others. Unless the user says, 2 for a radius
/// that the user has given, in a picture of 256 pixels a side, and in others as the 5/8th power of
/// the side, but never less than 1; for first_radius() so that they are as wide as for 2 pixels.
/// Indirect light has few edges, and how wide these are is a matter of the scene: only noise, of
/// which large pictures have less, keeps the best radius from growing with the side.
inline double indirect_radius_scale(const CameraPathSettings& settings, const Vec2i& resolution) {
    const double reach = std::max(1.0, 2 * size_power(resolution, 256));
    const bool is_given = settings.radius || settings.radius_pixels;
    return settings.indirect_radius.value_or(is_given ? reach
                                                      : 2 * reach / first_radius({}, resolution));
}

}  // namespace sunfleck::engine
