// Changes to a scene that a user asks for: film size, crop, energy compensation.
#pragma once

#include "scene/description.h"

#include <array>
#include <string>

namespace sunfleck::engine {

/// Returns whether a film may have that size: 1 to 65536 pixels a side, and at most 2^28 in all.
bool is_film_size(const Vec2i& size);
/// @throws Error  if is_film_size() is false.
void check_film_size(const Vec2i& size, const SourceLocation& where);

/// Sets another film size. The camera keeps the extent of its shorter axis; a crop keeps its
/// fraction of the film, at least one pixel per axis.
/// @param resolution  as is_film_size() has it.
void set_resolution(Camera& camera, FilmDescription& film, const Vec2i& resolution);
inline void set_resolution(SceneDescription& scene, const Vec2i& resolution) {
    set_resolution(scene.camera, scene.film, resolution);
}

/// Returns the pixels of a crop window, rounded as in pbrt-v4.
/// @param window  x0 x1 y0 y1 as fractions of the picture. @return x0 x1 y0 y1 in pixels.
std::array<int, 4> pixels_of_window(const std::array<double, 4>& window, const Vec2i& size);

/// Sets the crop.
/// @param crop  x0 x1 y0 y1 in pixels.
/// @param flag  the flag, for the error.
/// @throws Error  if the crop is not within the picture.
void set_crop(FilmDescription& film, const std::array<int, 4>& crop, const std::string& flag);

/// Enables energy compensation of rough metals and glass (bsdf/facet_losses.h), except under coats.
void compensate_energy(std::vector<Material>& materials);

}  // namespace sunfleck::engine
