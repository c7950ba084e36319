// The end of a medium around a whole scene: nothing of a sun or a sky would come through one
// without end.
//
// In:  a scene's description. Out: the same, with a sphere around it where the medium ends.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine {

/// Ends a medium at a sphere around all shapes and the camera. @param size  over their radius.
void end_at_sphere(SceneDescription& scene, MediumNumber medium, double size);

/// Ends the medium around the scene, if light from afar has to come through it, and warns of that.
/// Media of a density have an end of their own.
void end_outer_medium(SceneDescription& scene);

}  // namespace sunfleck::engine
