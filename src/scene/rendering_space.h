// Rendering space: the world, moved so that what is rendered stands near the origin.
//
// In:  a scene in the world's coordinates, those of its file, in double.
// Out: the same scene, every place less by one origin, so that floats resolve it
// (geometry/middle.h). A scene near the world's origin stays as it is. Objects that instances place
// are moved likewise, each in its own frame. Textures go on seeing the world's coordinates. Source:
// pbrt-v4's rendering space, there around the camera; here around the scene, so that all pictures
// of an animation are rendered in one space and a camera may be anywhere.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine {

/// Moves shapes, instances, lights, the camera and the frames of objects.
/// @return where the origin of rendering space is in the world: origin_near() the middle of what
/// does not emit, or of what does if there is nothing else.
Vec3d move_to_rendering_space(SceneDescription& scene);

}  // namespace sunfleck::engine
