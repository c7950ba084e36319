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
};

/// Of discs for indirect photons, over the radius for others. Unless the user says, they have a
/// 60th of the picture's side in footprints where others have two, but 1 to 3 times the radius of
/// others: indirect light has few edges, and how wide these are is a matter of the scene, not of
/// the pixels (docs/decisions.md).
inline double indirect_reach(const EyeSettings& settings, Vec2i resolution) {
    constexpr double kPixels = 120;  // of the side, for each radius of others
    const double side = std::sqrt(double(resolution.x) * resolution.y);
    return settings.indirect_radius.value_or(std::clamp(side / kPixels, 1.0, 3.0));
}

}  // namespace sunfleck
