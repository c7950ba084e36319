// The medium around everything: where distant and infinite light comes from.
#pragma once

#include "scene/scene.h"

namespace sunfleck {

/// Found by rays that leave the scene from the camera's position, through nothing that stops light;
/// empty space when there is none (then no light of far away comes to the camera).
/// (In pbrt-v4 such light starts in empty space, and shadow rays towards it do not.)
MediumNumber outer_medium_of(const Scene& scene);

}  // namespace sunfleck
