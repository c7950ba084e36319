// What a user may choose about camera paths and their visible points.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunfleck {

struct EyeSettings {
    double radius_pixels = 2;      // first radius over the pixel's footprint at the visible point
    std::optional<double> radius;  // instead: first radius in scene units
    std::optional<double> indirect_radius{};  // of discs for indirect photons, over that for
                                              // others; 1 or more; see indirect_reach()
    bool light_candidates = true;  // light samples of a vertex are several, or picked from several
};

/// Of discs for indirect photons, over the radius for others. Unless the user says, 2 in a picture
/// of 256 pixels a side, and in others as the 5/8th power of the side, but never less than 1.
/// Indirect light has few edges, and how wide these are is a matter of the scene: only noise, of
/// which large pictures have less, keeps the best radius from growing with the side
/// (docs/decisions.md).
inline double indirect_reach(const EyeSettings& settings, const Vec2i& resolution) {
    const double side = std::sqrt(double(resolution.x) * resolution.y) / 256;
    const double power = std::sqrt(side) * std::sqrt(std::sqrt(std::sqrt(side)));  // exact roots
    return settings.indirect_radius.value_or(std::max(1.0, 2 * power));
}

}  // namespace sunfleck
