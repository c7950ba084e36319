// The data that all cameras with a flat film have: place, film, screen and lens.
#pragma once

#include "math/vector.h"

namespace sunfleck::engine {

/// Left-handed camera frame: looks along +z, x right, y up.
struct ScreenCamera {
    Matrix camera_to_world;
    Vec2i resolution{1280, 720};  // of the whole film
    /// What the film spans in camera space, at z = 1 if it is seen in perspective: x from
    /// screen_min.x to screen_max.x.
    Vec2d screen_min{-1.777777, -1};
    Vec2d screen_max{1.777777, 1};
    double lens_radius = 0;       // camera frame; 0 is a pinhole
    double focal_distance = 1e6;  // z of the plane that is sharp, camera frame
};

}  // namespace sunfleck::engine
