// How a camera sees a point: the inverse of camera_ray(), for paths that come from the lights.
//
// In:  a point of the world and one of the lens. Out: where on the film it is seen, from where, and
// how large.
#pragma once

#include "camera/camera.h"

#include <optional>

namespace sunfleck::engine {

struct Sight {
    Vec2d film;       // pixels from the top left corner, as camera_ray() takes them; may be outside
    Vec3d origin;     // of the camera ray that meets the point
    double area = 0;  // of the film, in pixels, that a unit area there facing the camera covers
};

class Projection {
public:
    explicit Projection(Camera camera);

    /// @param lens  in (0,1)^2, as for camera_ray(). @return nothing for what lies behind the
    /// camera, or in its very point.
    std::optional<Sight> sight_of(const Vec3d& point, const Vec2d& lens) const;

private:
    Camera camera_;
    Matrix world_to_camera_;
    double volume_ = 1;  // of the unit cube of the camera's frame, in the world
};

}  // namespace sunfleck::engine
