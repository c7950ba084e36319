// CameraView: the camera of a scene with its resolution and crop.
#pragma once

#include "camera/camera.h"

namespace sunfleck::engine {

struct CameraView {
    const Camera& camera;
    Vec2i resolution;  // of the whole film

    /// Returns a ray through the centre of the lens. @param share  position as fractions of the
    /// film.
    CameraRay ray_at(const Vec2d& share) const {
        return camera_ray(camera, Vec2d(resolution) * share, {0.5, 0.5});
    }
    CameraRay middle_ray() const { return ray_at(Vec2d(0.5)); }
};

}  // namespace sunfleck::engine
