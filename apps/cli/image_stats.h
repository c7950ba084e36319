// What is known of the errors of a picture as a whole, for stats.json (docs/reference/stats.md) and
// the user.
#pragma once

#include "film/target_error.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace sunfleck::engine {

/// `image` of stats.json: names appear as soon as their values are known.
nlohmann::ordered_json image_json(const Film& film, ErrorTerms terms);

/// That a picture which was to be extrapolated is not, and why: a line, or none.
std::vector<std::string> extrapolation_warnings(const Film& film, bool wanted);

}  // namespace sunfleck::engine
