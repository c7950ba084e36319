// Photon paths by multilevel splitting on visibility: the sampler `adaptive`.
//
// In:  what is seen in a pass, a stratum of lights with its plan. Out: photons in chunks, weighted
// so that their sum is the stratum's light in this pass: the estimate's N is one.
#pragma once

#include "photon/light_stratum.h"
#include "visible_points/photon_chunk.h"

#include <functional>
#include <vector>

namespace sunfleck::engine {

/// Called with chunks of whole paths: marks the photons that were taken. @return counts.
using DepositChunks = std::function<Statistics(std::vector<PhotonChunk>&)>;

struct AdaptivePaths {
    SplittingCounts splitting;
    Statistics statistics;
};

/// @param octree  over the view. @param stratum  its plan with at least one level.
/// @param pass  with the stratum's part.
AdaptivePaths trace_adaptive_paths(const PhotonContext& view, const VisiblePointOctree& octree,
                                   PassId pass, const LightStratum& stratum,
                                   const DepositChunks& deposit);

}  // namespace sunfleck::engine
