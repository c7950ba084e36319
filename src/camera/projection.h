// Projection: the inverse of camera_ray(), for light paths that connect to the camera.
//
// In:  a point of the world and one of the lens. Out: film point, ray origin and scale.
#pragma once

#include "camera/camera.h"

#include <optional>

namespace sunfleck::engine {

struct Sight {
    Vec2d film;    // in pixels from the top left corner as in camera_ray(); may be outside the film
    Vec3d origin;  // of the camera ray through the point
    double area = 0;  // film area in pixels per unit area at the point that faces the camera
};

class Projection {
public:
    explicit Projection(Camera camera);

    /// @param lens  in (0,1)^2 as for camera_ray().
    /// @return nothing for points behind the camera or at its position.
    std::optional<Sight> sight_of(const Vec3d& point, const Vec2d& lens) const;

private:
    Camera camera_;
    Matrix world_to_camera_;
    double volume_ = 1;  // of the unit cube of camera space, in the world
};

}  // namespace sunfleck::engine
