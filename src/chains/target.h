// Target: the distribution of a chain, a level set with lower density where guided paths bring
// light.
//
// In:  a primary sample. Out: its importance, the target density up to a factor, and the share of
// its light that chains bring.
// Equations: docs/method/sampling.md, eqs. (16) and (42).
#pragma once

#include "chains/path_space.h"
#include "chains/stored_sample.h"
#include "guide/guided_points.h"

#include <algorithm>

namespace sunfleck::engine {

/// Returns the emission of a sample. With guides, every path reads all of these dimensions, because
/// membership in the guided region must not depend on chance.
inline EmissionPoint emission_of(const StoredSample& sample) {
    EmissionPoint point;
    for (std::uint32_t s = 0; s < kGuidedDimensions; ++s)
        point[s] = sample.has(s) ? to_unit(sample[s]) : 0.5;
    return point;
}

/// What chains do with a sample.
struct ChainShare {
    double importance = 1;  // the target density up to a factor: zero if they never go there
    double light = 1;       // fraction of the sample's light that they bring
};

/// Guided paths of a pass, and how they share the light with chains. There are two ways:
/// - Beside splitting, they bring a fraction of the light of the region that the map covers, eq.
/// (16).
/// - A map of full support brings everything, but no path weighs more than a bound. The chains
/// bring what that leaves, eq. (42).
struct GuidedPlan {
    EmissionGuide map;
    std::uint32_t paths = 0;  // zero if there is no guide
    double importance = 1;    // g in eq. (16): of the guided region for the chains, in (0,1]
    double own_share = 1;     // s in eq. (16): fraction of the light that they bring, in [0,1]
    double most_weight = kUnbounded;  // w in eq. (42); it alone counts if there is one

    /// Returns whether guided paths come there.
    bool reaches(const StoredSample& sample) const {
        return paths > 0 && map.covers(emission_of(sample));
    }
    ChainShare for_chains(const StoredSample& sample) const {
        if (most_weight < kUnbounded) {
            const double rest = std::max(0.0, 1 - most_weight * map.density(emission_of(sample)));
            return {rest, rest};
        }
        return reaches(sample) ? ChainShare{importance, 1 - own_share} : ChainShare{};
    }
};

struct Target {
    int height = kVisible;               // least height of paths in the set
    const GuidedPlan* guided = nullptr;  // null: the same density everywhere

    ChainShare share_of(const StoredSample& sample) const {
        return guided == nullptr ? ChainShare{} : guided->for_chains(sample);
    }
};

}  // namespace sunfleck::engine
