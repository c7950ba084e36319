// Warnings about dark pictures: black ones, and those that lack the flux of photons.
#pragma once

#include "film/film.h"

#include <functional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Returns the warnings, a line each.
/// @param share_lit  asked where no pass has brought any photon: the share of the picture that
///                   should have light by photons (planning/missing_light.h). None: nobody knows.
std::vector<std::string> darkness_warnings(const Film& film,
                                           const std::function<double()>& share_lit = {});

}  // namespace sunfleck::engine
