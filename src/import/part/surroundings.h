// What a part stands in: a ground under it, and a camera before it.
#pragma once

#include "scene/description.h"
#include "scene/import_settings.h"

namespace sunfleck::engine {

/// Adds a matt ground on which the scene stands, so large that it fills the picture of
/// set_part_view(). It is a hair's breadth below, so that glass on it has air under it.
/// @param part  bounds of what stands, not empty.
void add_ground(SceneDescription& scene, const Bounds& part, UpAxis up);

/// Sets the camera: from the front (-y where z is up, z where y is up), to the right and above. It
/// sees all shapes of the scene, which are meshes.
void set_part_view(SceneDescription& scene, UpAxis up);

}  // namespace sunfleck::engine
