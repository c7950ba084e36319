// Target: the distribution of a chain, a level set with lower density in the guided region.
//
// In:  a primary sample. Out: its importance, the target density up to a factor.
// Equations: docs/method/sampling.md, eq. (16).
#pragma once

#include "chains/path_space.h"
#include "chains/stored_sample.h"
#include "guide/emission_guide.h"

namespace sunfleck::engine {

/// Returns the emission of a sample. With guides, every path reads all of these dimensions, because
/// membership in the guided region must not depend on chance.
inline EmissionPoint emission_of(const StoredSample& sample) {
    EmissionPoint point;
    for (std::uint32_t s = 0; s < kGuidedDimensions; ++s)
        point[s] = sample.has(s) ? to_unit(sample[s]) : 0.5;
    return point;
}

/// The guided region, where chains need less density because guided paths sample it.
struct GuidedRegion {
    const EmissionGuide* map = nullptr;  // null if there is no guide
    double importance = 1;               // in the region, in (0,1]

    bool contains(const StoredSample& sample) const {
        return map != nullptr && map->covers(emission_of(sample));
    }
};

struct Target {
    int height = kVisible;  // least height of paths in the set
    GuidedRegion guided = {};
};

}  // namespace sunfleck::engine
