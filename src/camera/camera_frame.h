// The frame of a camera, of whichever kind.
#pragma once

#include "camera/camera.h"

namespace sunfleck::engine {

inline const Matrix& frame_of(const Camera& camera) {
    return std::visit([](const auto& one) -> const Matrix& { return one.camera_to_world; }, camera);
}

}  // namespace sunfleck::engine
