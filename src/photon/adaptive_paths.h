// Photon paths by the visibility ladder: the sampler `adaptive`.
//
// In:  what is seen in a pass, a group of lights with its plan. Out: photons in batches, weighted
// so that their sum is the group's light in this pass: the estimate's N is one.
#pragma once

#include "photon/light_stratum.h"
#include "visible_points/photon_chunk.h"

#include <functional>
#include <vector>

namespace sunfleck {

/// Called with batches of whole paths: marks the photons that were taken. @return counts.
using DepositBatches = std::function<Statistics(std::vector<PhotonBatch>&)>;

struct AdaptivePaths {
    LadderCounts ladder;
    Statistics statistics;
};

/// @param octree  over the view. @param group  its plan with at least one level.
/// @param pass  with the group's part.
AdaptivePaths trace_adaptive_paths(const PhotonView& view, const ViewOctree& octree, PassId pass,
                                   const PhotonGroup& group, const DepositBatches& deposit);

}  // namespace sunfleck
