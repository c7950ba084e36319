// The camera of a scene with the extent of its picture.
#pragma once

#include "camera/camera.h"

namespace sunfleck::engine {

struct CameraView {
    const Camera& camera;
    Vec2i resolution;  // of the whole film

    /// A ray through the middle of the lens. @param share  of the film's width and height.
    CameraRay ray_at(const Vec2d& share) const {
        return camera_ray(camera, Vec2d(resolution) * share, {0.5, 0.5});
    }
    CameraRay middle_ray() const { return ray_at(Vec2d(0.5)); }
};

}  // namespace sunfleck::engine
