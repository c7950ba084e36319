// Parameters that all cameras with a flat film share: position, film, screen and lens.
#pragma once

#include "math/vector.h"

namespace sunfleck::engine {

/// The camera frame is left-handed: it looks along +z, x points right, y up.
struct ScreenCamera {
    Matrix camera_to_world;
    Vec2i resolution{1280, 720};  // of the whole film
    /// Extent of the film in camera space (at z = 1 for perspective): x from screen_min.x to
    /// screen_max.x.
    Vec2d screen_min{-1.777777, -1};
    Vec2d screen_max{1.777777, 1};
    double lens_radius = 0;       // in camera space; 0 is a pinhole
    double focal_distance = 1e6;  // z of the plane in focus, in camera space
};

}  // namespace sunfleck::engine
