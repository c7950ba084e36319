// Guide search: where a pilot looks for emission that splitting does not find, by importons and at
// edges of surfaces.
#pragma once

#include "core/random.h"
#include "random_numbers/emission_point.h"
#include "random_numbers/path_range.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace sunfleck::engine {

/// What importons found.
struct WalkedEmission {
    std::vector<WeightedEmission>
        guide_samples;    // emission that may be visible, and the flux it brings
    double possible = 0;  // the flux of all samples of light, were nothing in the way
};

/// Sources of first guide samples, where splitting may fail and a guide helps.
struct GuideSource {
    /// Importons of a pass, by their numbers.
    using Walks = std::function<WalkedEmission(PassId, PathRange)>;

    bool is_on = true;  // off: no guide at all
    Walks walks = {};   // none: splitting alone
    /// Emission that passes close to an edge, wherever it goes, by the numbers of tries.
    using Edges = std::function<std::vector<WeightedEmission>(PassId, PathRange)>;
    Edges edges = {};
    /// Flux that an importon finds of all lights together, about: the picture's brightness.
    std::function<double(PassId)> seen = {};
    /// Importons that a long search is worth, where a short one has found nothing.
    std::size_t most_walks = std::numeric_limits<std::size_t>::max();
};

}  // namespace sunfleck::engine
