// The photons of a pass, group by group.
//
// In:  what is seen in the pass, groups of lights with their plans. Out: their light, added to an
// image, and counts.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "estimate/photon_counts.h"
#include "photon/light_stratum.h"
#include "photon/settings.h"

#include <vector>

namespace sunfleck {

/// What photons counted.
struct PhotonTotals {
    Statistics statistics;
    double visible_fraction = 0;      // this pass's estimate, of uniform paths from all lights
    std::vector<GroupCounts> groups;  // as they were given

    /// Another draw of the same pass, with its share in the mean over draws.
    void add(const PhotonTotals& draw, double share);
};

/// Where the light of photons is added.
struct PhotonTarget {
    PassImage& image;
    PhotonCounts* taken = nullptr;  // photons by pixel, or none
};

/// Adds the light of the photons of a pass, or of one draw of it, to the image.
/// @param sampler  random, uniform or adaptive. @param id  names their random numbers.
PhotonTotals trace_photons(const PhotonView& view, PassId id, PhotonSampler sampler,
                           const std::vector<PhotonGroup>& groups, const PhotonTarget& to);

/// Counts uniform paths: each visible one brought light once. @return the share of these.
double count_uniform(Statistics& counts, Statistics& all);

}  // namespace sunfleck
