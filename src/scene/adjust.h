// What the command line changes in a scene before it is built.
#pragma once

#include "scene/description.h"

namespace sunfleck {

/// Another film size. The view keeps the extent of its shorter axis; a crop keeps its share, of a
/// pixel at least each way.
/// @param resolution  positive, at most 65536 a side.
void set_resolution(SceneDescription& scene, const Vec2i& resolution);

/// @param crop  x0 x1 y0 y1 in pixels. @throws Error where that is not a part of the picture.
void set_crop(SceneDescription& scene, const std::array<int, 4>& crop);

/// Rough metals and glass give back what their facets lose (bsdf/facet_losses.h); coats do not.
void compensate_energy(SceneDescription& scene);

}  // namespace sunfleck
