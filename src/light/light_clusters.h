// Lights that are looked at together where one by one would be too many.
//
// In:  the scene's sources of light and the weights of its lights. Out: lists of lights.
#pragma once

#include "light/choice.h"

namespace sunfleck::engine {

/// Lights first .. first + count - 1 of a scene's list.
struct LightRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Sources without power are in none. Where the others are at most `most`, each is a cluster. Else
/// the strongest half of `most` are each by themselves, so that none of them hides a weak one, and
/// the rest are runs of neighbours in the list, as many again.
/// @param most  even, at least 2.
std::vector<std::vector<std::uint32_t>> light_clusters(const std::vector<LightRange>& sources,
                                                       const LightChoice& weights,
                                                       std::size_t most);

}  // namespace sunfleck::engine
