// A perspective camera with a thin lens, and the reconstruction filter by importance sampling.
#pragma once

#include "math/vector.h"

#include <array>
#include <optional>

namespace sunfleck {

/// A camera path's first segment, in double: far worlds need it.
struct CameraRay {
    Vec3d origin;
    Vec3d direction;  // unit
    /// Width of a pixel per unit distance along this ray: square root of the solid angle (sr) that
    /// the pixel around `film` spans at the centre of the lens, in the world.
    float footprint_angle = 0;
};

/// pbrt-v4's "perspective". Left-handed camera frame: looks along +z, x right, y up.
struct PerspectiveCamera {
    Matrix camera_to_world;
    Vec2i resolution{1280, 720};  // of the whole film
    /// What the film spans at z = 1 in camera space: x from screen_min.x to screen_max.x.
    Vec2d screen_min{-1.777777, -1};
    Vec2d screen_max{1.777777, 1};
    double lens_radius = 0;       // camera frame; 0 is a pinhole
    double focal_distance = 1e6;  // z of the plane that is sharp, camera frame

    /// @param film  in pixels from the top left corner of the film; y grows downwards.
    /// @param lens  in (0,1)^2; concentric map to the lens.
    CameraRay ray(const Vec2d& film, const Vec2d& lens) const;
};

/// `fov` in degrees is that of the shorter axis; the screen spans [-a, a] x [-1, 1] tan(fov / 2)
/// for frame_aspect a >= 1, and [-1, 1] x [-1/a, 1/a] for a < 1; `screen_window` (x0 x1 y0 y1)
/// overrides the span before tan().
/// @param fov  in (0, 180). @param frame_aspect  width / height, positive.
PerspectiveCamera make_perspective(const Matrix& camera_to_world, const Vec2i& resolution,
                                   double fov, double frame_aspect,
                                   const std::optional<std::array<double, 4>>& screen_window);

}  // namespace sunfleck
