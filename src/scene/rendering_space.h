// Rendering space: the world, translated so that the rendered objects are near the origin.
//
// In:  a scene in world coordinates, those of its file, in double.
// Out: the same scene minus an origin, so that floats resolve it (geometry/middle.h). A scene near
// the world's origin is not moved. Objects of instances are moved likewise, each in its own frame.
// Textures use world coordinates.
// Source: pbrt-v4's rendering space, which is centred at the camera; here it is centred at the
// scene, so that all frames of an animation share one space and the camera may be anywhere.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine {

/// Translates shapes, instances, lights, the camera and the frames of objects.
/// @return the origin of rendering space in the world: origin_near() of the shapes that do not
/// emit, or of those that do if there are no others.
Vec3d move_to_rendering_space(SceneDescription& scene);

/// Moves a camera of the world into the rendering space of that origin.
void move_to(const Vec3d& origin, Camera& camera);

}  // namespace sunfleck::engine
