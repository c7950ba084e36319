// Deposits that also count, pixel by pixel, the photons that were taken: for local radii.
//
// Source: the splatting variant of stochastic progressive photon mapping, Hachisuka and Jensen 2009
// (M of section 4 is what is counted).
#pragma once

#include "estimate/deposit.h"
#include "measurement/repeated_photons.h"

#include <atomic>
#include <vector>

namespace sunfleck {

/// Photons by pixel, repeats counted each.
using PhotonCounts = std::vector<std::atomic<std::uint64_t>>;

/// What a deposit needs to know of the pass.
struct CountingDeposit {
    const PassScene& pass;
    const VisiblePointIndex& index;
    std::uint32_t paths = 1;  // N of the estimate
    PassImage& image;
    PhotonCounts& taken;  // one of each pixel

    /// Adds every photon as often as it repeats: sums of integers, the same for any number of
    /// threads. @return counts.
    Statistics operator()(const RepeatedPhotons& photons) const;
};

}  // namespace sunfleck
