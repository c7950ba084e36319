// Luminaires: measured intensities in place of those of a scene's points and spots.
#pragma once

#include "import/scene_request.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Gives lights the intensities of the files that are asked for. The nadir of a point's luminaire
/// is down, and its horizontal angles go from x; a spot's nadir is its axis.
/// @param up  of the scene's world.
/// @throws Error  for a light that does not exist or is no point and no spot, and for a file that
/// cannot be read.
void set_luminaires(SceneDescription& scene, const std::vector<AskedLuminaire>& asked, UpAxis up);

}  // namespace sunfleck::engine
