// The photons of a pass, stratum by stratum.
//
// In:  what is seen in the pass, strata of lights with their plans. Out: their light, added to an
// image, and counts.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "estimate/photon_counts.h"
#include "photon/light_stratum.h"
#include "photon/settings.h"

#include <vector>

namespace sunfleck::engine {

/// What photons counted.
struct PhotonTotals {
    Statistics statistics;
    double visible_fraction = 0;        // this pass's estimate, of uniform paths from all lights
    std::vector<StratumCounts> strata;  // as they were given

    /// Another subpass of the same pass, with its share in the mean over subpasses.
    void add(const PhotonTotals& subpass, double share);
};

/// Where the light of photons is added.
struct PhotonTarget {
    PassImage& image;
    PhotonCounts* taken = nullptr;  // photons by pixel, or none
};

/// Adds the light of the photons of a pass, or of one subpass of it, to the image.
/// @param sampler  random, uniform or adaptive. @param id  names their random numbers.
PhotonTotals trace_photons(const PhotonContext& view, PassId id, PhotonSampler sampler,
                           const std::vector<LightStratum>& strata, const PhotonTarget& to);

/// Counts uniform paths: each visible one brought light once. @return the share of these.
double count_uniform(Statistics& counts, Statistics& all);

}  // namespace sunfleck::engine
