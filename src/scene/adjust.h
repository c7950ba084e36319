// What the command line changes in a scene before it is built.
#pragma once

#include "scene/description.h"

#include <array>
#include <string>

namespace sunfleck::engine {

/// Another film size. The view keeps the extent of its shorter axis; a crop keeps its share, of a
/// pixel at least each way.
/// @param resolution  positive, at most 65536 a side.
void set_resolution(SceneDescription& scene, const Vec2i& resolution);

/// The pixels of a crop window, rounded as in pbrt-v4.
/// @param window  x0 x1 y0 y1 as fractions of the picture. @return x0 x1 y0 y1 in pixels.
std::array<int, 4> pixels_of_window(const std::array<double, 4>& window, const Vec2i& size);

/// @param crop  x0 x1 y0 y1 in pixels. @param flag  that asked for it.
/// @throws Error where that is not a part of the picture.
void set_crop(SceneDescription& scene, const std::array<int, 4>& crop, const std::string& flag);

/// Rough metals and glass give back what their facets lose (bsdf/facet_losses.h); coats do not.
void compensate_energy(SceneDescription& scene);

}  // namespace sunfleck::engine
