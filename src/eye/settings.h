// What a user may choose about camera paths and their visible points.
#pragma once

#include <optional>

namespace sunfleck {

struct EyeSettings {
    double radius_pixels = 2;      // first radius over the pixel's footprint at the visible point
    std::optional<double> radius;  // instead: first radius in scene units
};

}  // namespace sunfleck
