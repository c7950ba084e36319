// What a chain's states are spread over: a set of paths, and less of it where others sample, too.
//
// In:  a primary sample. Out: its importance, the density of the chain's target but for a factor.
#pragma once

#include "sampler/emission_map.h"
#include "sampler/path_space.h"
#include "sampler/stored_sample.h"

namespace sunfleck {

/// A sample's emission. Where maps are used, every path reads all of these numbers: whether it is
/// covered must not depend on chance.
inline EmissionPoint emission_of(const StoredSample& sample) {
    EmissionPoint point;
    for (std::uint32_t s = 0; s < kMappedSlots; ++s)
        point[s] = sample.has(s) ? to_unit(sample[s]) : 0.5;
    return point;
}

/// What a map covers is sampled by other paths. Chains still go through it, as over a bridge
/// between the other places, but less often.
struct Bridge {
    const EmissionMap* map = nullptr;  // none: nothing is covered
    double importance = 1;             // of what is covered, in (0,1)

    bool covers(const StoredSample& sample) const {
        return map != nullptr && map->covers(emission_of(sample));
    }
};

struct Target {
    int height = kVisible;  // of paths in the set, at least
    Bridge bridge = {};

    double importance(const StoredSample& sample) const {
        return bridge.covers(sample) ? bridge.importance : 1;
    }
};

}  // namespace sunfleck
