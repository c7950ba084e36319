// Photon paths by the paper's own algorithm: the sampler `paper`.
//
// In:  what is seen in a pass, the chain as the passes before left it. Out: photons, each with the
// number of iterations that its path was splatted in; the chain as this pass leaves it.
#pragma once

#include "measurement/repeated_photons.h"
#include "photon/adaptive_paths.h"
#include "photon/paper_chain.h"

namespace sunfleck {

struct PaperPass {
    PassId id;
    std::uint32_t paths = 0;  // iterations of Fig. 3
    bool replica_exchange = true;
};

/// Called with the photons of many paths. @return counts.
using SplatPhotons = std::function<Statistics(const RepeatedPhotons&)>;

/// Uniform paths are tested on all threads, the chain runs on one: the result does not depend on
/// the number of threads. @return counts.
Statistics trace_paper_paths(const PhotonView& view, const PaperPass& pass, PaperState& state,
                             const SplatPhotons& splat);

}  // namespace sunfleck
