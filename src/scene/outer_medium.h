// The medium around everything: where distant and infinite light comes from.
#pragma once

#include "scene/camera_view.h"
#include "scene/media.h"
#include "scene/surfaces.h"

namespace sunfleck::engine {

/// Found by rays that leave the scene from the camera's position, through nothing that stops light;
/// empty space when there is none (then no light of far away comes to the camera).
/// (In pbrt-v4 such light starts in empty space, and shadow rays towards it do not.)
/// @param at_camera  the medium in which the camera stands.
MediumNumber outer_medium_of(const Surfaces& surfaces, const CameraView& view,
                             MediumNumber at_camera);

}  // namespace sunfleck::engine
