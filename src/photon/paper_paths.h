// Photon paths by the paper's own algorithm: the sampler `paper`.
//
// In:  the visible points of a pass, the chain's state after the passes before. Out: photons, with
// as many copies as iterations in which their path was splatted; the new state.
#pragma once

#include "photon/adaptive_paths.h"
#include "photon/paper_chain.h"

namespace sunfleck::engine {

struct PaperPass {
    PassId id;
    std::uint32_t paths = 0;  // iterations of Fig. 3
    bool replica_exchange = true;
};

/// Traces uniform paths on all threads and the chain on one: the result does not depend on the
/// number of threads. @return statistics.
Statistics trace_paper_paths(const PhotonContext& photon_context, const PaperPass& pass,
                             PaperState& state, const DepositChunks& deposit);

}  // namespace sunfleck::engine
