// The outer medium: the one around the scene, from which distant and infinite light comes.
#pragma once

#include "scene/camera_view.h"
#include "scene/media.h"
#include "scene/surfaces.h"

namespace sunfleck::engine {

/// Finds the outer medium by rays that leave the scene from the camera through transmitting
/// surfaces; empty space if there is none (then no distant light reaches the camera). In pbrt-v4
/// such light starts in empty space, while shadow rays towards it do not.
/// @param at_camera  the medium of the camera.
MediumNumber outer_medium_of(const Surfaces& surfaces, const CameraView& view,
                             MediumNumber at_camera);

}  // namespace sunfleck::engine
