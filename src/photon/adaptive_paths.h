// Photon paths by multilevel splitting on visibility: the sampler `adaptive`.
//
// In:  the visible points of a pass, a light stratum with its plan. Out: photons in chunks,
// weighted so that their sum is the light of the stratum in this pass: the estimate's N is one.
#pragma once

#include "photon/light_stratum.h"
#include "visible_points/photon_chunk.h"

#include <cstdint>
#include <functional>
#include <span>
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

/// Brings what the guided paths of a stratum leave, because their weight is bounded.
/// @param stratum  with a plan of one level. @param bounded  numbers of the visible paths whose
/// weight was bounded.
AdaptivePaths trace_remainder(const PhotonContext& photon_context, const VisiblePointOctree& octree,
                              PassId pass, const LightStratum& stratum,
                              std::span<const std::uint32_t> bounded, const DepositChunks& deposit);

}  // namespace sunfleck::engine
