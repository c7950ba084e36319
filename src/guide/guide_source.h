// GuideSource: the guide search, by which a pilot finds emission that splitting does not:
// importons, and edges of surfaces.
#pragma once

#include "core/random.h"
#include "random_numbers/emission_point.h"
#include "random_numbers/path_range.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace sunfleck::engine {

/// Results of importons.
struct WalkedEmission {
    std::vector<WeightedEmission> guide_samples;  // emission that may be visible, with its flux
    double possible = 0;                          // unoccluded flux of all light samples
};

/// Sources of initial guide samples, for where splitting may fail and a guide helps.
struct GuideSource {
    /// Traces importons of a pass by number.
    using Walks = std::function<WalkedEmission(PassId, PathRange)>;

    bool is_on = true;  // false: no guide at all
    Walks walks = {};   // empty: splitting alone
    /// Samples emission close to edges, wherever it goes, by number.
    using Edges = std::function<std::vector<WeightedEmission>(PassId, PathRange)>;
    Edges edges = {};
    /// Returns the approximate flux that an importon finds of all lights: the brightness of the
    /// picture.
    std::function<double(PassId)> seen = {};
    /// Limit of importons in a long search, after a short one has found nothing.
    std::size_t most_walks = std::numeric_limits<std::size_t>::max();
};

}  // namespace sunfleck::engine
