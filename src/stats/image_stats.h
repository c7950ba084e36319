// Error estimates of the whole picture, for stats.json (docs/reference/stats.md) and warnings.
#pragma once

#include "film/target_error.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Returns `image` of stats.json. Names appear as soon as their values are known.
nlohmann::ordered_json image_json(const Film& film, ErrorTerms terms);

/// Returns a line that says why a picture is not extrapolated, if that was wanted; or none.
std::vector<std::string> extrapolation_warnings(const Film& film, bool wanted);

}  // namespace sunfleck::engine
