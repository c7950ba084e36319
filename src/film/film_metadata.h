// What a picture's file says of the render that made it.
#pragma once

#include "film/film.h"

#include <map>
#include <string>

namespace sunfleck::engine {

/// Setting of the film key for pixels that are not square: their width over their height.
inline constexpr const char* kPixelAspect = "pixel_aspect";

/// Returns texts by name: `software`, `passes`, `photon_paths` where there are some, `seed`,
/// `scene_hash`, and `settings`, a line each. They depend on the film alone, not on time, machine
/// or threads.
std::map<std::string, std::string> film_metadata(const Film& film);

/// Returns the width of a pixel over its height.
float pixel_aspect_of(const FilmKey& key);

}  // namespace sunfleck::engine
