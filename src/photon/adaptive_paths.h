// Photon paths by multilevel splitting on visibility: the sampler `adaptive`.
//
// In:  the visible points of a pass, a light stratum with its plan. Out: photons in chunks,
// weighted so that their sum is the light of the stratum in this pass: the estimate's N is one.
#pragma once

#include "chains/guided_remainder.h"
#include "photon/light_stratum.h"
#include "visible_points/photon_chunk.h"

#include <functional>
#include <vector>

namespace sunfleck::engine {

/// Deposits chunks of whole paths and marks accepted photons. @return statistics.
using DepositChunks = std::function<Statistics(std::vector<PhotonChunk>&)>;

struct AdaptivePaths {
    SplittingCounts splitting;
    Statistics statistics;
};

/// @param octree  over the visible points.
/// @param stratum  with a plan of at least one level.
/// @param pass  with the part of the stratum.
AdaptivePaths trace_adaptive_paths(const PhotonContext& photon_context,
                                   const VisiblePointOctree& octree, PassId pass,
                                   const LightStratum& stratum, const DepositChunks& deposit);

/// Brings what guided paths leave, because their weight is bounded. @param lights  where they
/// start.
AdaptivePaths trace_remainder(const PhotonContext& photon_context, const VisiblePointOctree& octree,
                              const LightChoice& lights, const GuidedRemainder& rest,
                              const DepositChunks& deposit);

}  // namespace sunfleck::engine
