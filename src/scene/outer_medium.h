// The medium around everything: where distant and infinite light comes from.
#pragma once

#include "scene/scene.h"

namespace sunfleck {

/// Can a straight ray go on beyond a surface? It can where the surface names what is beyond it, or
/// where light passes it without a change of medium.
bool can_be_passed(const Scene& scene, const Hit& hit);

/// Found by rays that leave the scene from the camera's place, past nothing that hides what is
/// beyond it; empty space when there is none (then no light of far away comes to the camera).
/// (In pbrt-v4 such light starts in empty space, and shadow rays towards it do not.)
MediumNumber outer_medium_of(const Scene& scene);

}  // namespace sunfleck
