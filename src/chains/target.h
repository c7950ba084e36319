// What a chain's states are spread over: a set of paths, and less of it where others sample, too.
//
// In:  a primary sample. Out: its importance, the density of the chain's target but for a factor.
#pragma once

#include "chains/path_space.h"
#include "chains/stored_sample.h"
#include "guide/emission_guide.h"

namespace sunfleck::engine {

/// A sample's emission. Where guides are used, every path reads all of these numbers: whether it is
/// in the guided region must not depend on chance.
inline EmissionPoint emission_of(const StoredSample& sample) {
    EmissionPoint point;
    for (std::uint32_t s = 0; s < kGuidedDimensions; ++s)
        point[s] = sample.has(s) ? to_unit(sample[s]) : 0.5;
    return point;
}

/// Places where paths through a guide start, too: chains need not be there as often as elsewhere.
struct GuidedRegion {
    const EmissionGuide* map = nullptr;  // none: nothing is covered
    double importance = 1;               // of what is covered, in (0,1]

    bool contains(const StoredSample& sample) const {
        return map != nullptr && map->covers(emission_of(sample));
    }
};

struct Target {
    int height = kVisible;  // of paths in the set, at least
    GuidedRegion cover = {};
};

}  // namespace sunfleck::engine
