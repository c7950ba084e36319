// Photon paths by the visibility ladder: the sampler `adaptive`.
//
// In:  what is seen in a pass, a plan learned before. Out: photons in batches, weighted so that
// their sum is the pass's light: the estimate's N is one.
#pragma once

#include "measurement/photon_batch.h"
#include "measurement/transport.h"
#include "measurement/visible_point_index.h"
#include "sampler/pilot.h"
#include "scene/pass_scene.h"

#include <functional>

namespace sunfleck {

/// What photons of a pass go through and towards.
struct PhotonView {
    const PassScene& scene;
    const TransportSettings& transport;
    const VisiblePointIndex& index;
};

/// Called with batches of whole paths: marks the photons that were taken. @return counts.
using DepositBatches = std::function<Statistics(std::vector<PhotonBatch>&)>;

/// @param epoch  names the random numbers. @param paths  of a pass, at least 2.
PilotResult learn_ladder(const PhotonView& view, std::uint64_t seed, std::uint32_t epoch,
                         std::uint32_t paths);

/// @param plan  with at least one level. @param statistics  counts are added.
LadderCounts trace_adaptive_paths(const PhotonView& view, PassId pass, const LadderPlan& plan,
                                  const DepositBatches& deposit, Statistics& statistics);

}  // namespace sunfleck
