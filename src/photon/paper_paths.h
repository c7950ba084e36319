// Photon paths by the paper's own algorithm: the sampler `paper`.
//
// In:  what is seen in a pass, the chain as the passes before left it. Out: photons, as many copies
// of each as iterations that its path was splatted in; the chain as this pass leaves it.
#pragma once

#include "photon/adaptive_paths.h"
#include "photon/paper_chain.h"

namespace sunfleck::engine {

struct PaperPass {
    PassId id;
    std::uint32_t paths = 0;  // iterations of Fig. 3
    bool replica_exchange = true;
};

/// Uniform paths are traced on all threads, the chain runs on one: the result does not depend on
/// the number of threads. @return counts.
Statistics trace_paper_paths(const PhotonContext& view, const PaperPass& pass, PaperState& state,
                             const DepositChunks& deposit);

}  // namespace sunfleck::engine
