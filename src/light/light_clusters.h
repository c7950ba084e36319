// Clusters of lights, which adaptive strategies treat as one where single lights would be too many.
//
// In:  the sources of the scene and the weights of its lights. Out: lists of lights.
#pragma once

#include "light/choice.h"

namespace sunfleck::engine {

/// Lights first .. first + count - 1 of a scene's list.
struct LightRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Makes clusters of sources; those without power are left out. Up to `most` sources each form a
/// cluster. Otherwise the strongest most / 2 sources each form one, so that none of them hides a
/// weak one, and the others form as many runs of neighbours in the list.
/// @param most  even, at least 2.
std::vector<std::vector<std::uint32_t>> light_clusters(const std::vector<LightRange>& sources,
                                                       const LightChoice& weights,
                                                       std::size_t most);

}  // namespace sunfleck::engine
