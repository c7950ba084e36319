// Doubts about dark pictures: light that photons should have brought and did not, and black ones.
#pragma once

#include "film/film.h"

#include <functional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A line for each doubt.
/// @param share_lit  asked where no pass has brought any photon: the share of the picture that
///                   should have light by photons (planning/missing_light.h). None: nobody knows.
std::vector<std::string> darkness_warnings(const Film& film,
                                           const std::function<double()>& share_lit = {});

}  // namespace sunfleck::engine
