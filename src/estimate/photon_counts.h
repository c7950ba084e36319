// Photons that were taken, by pixel, copies counted each: what local radii follow.
//
// Source: M of section 4, Hachisuka and Jensen 2009, "Stochastic Progressive Photon Mapping". Sums
// of integers: the same for any number of threads.
#pragma once

#include "aovs/pass_image.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

using PhotonCounts = std::vector<std::atomic<std::uint64_t>>;

/// Adds them to the AOV of samples, which must be measured.
inline void add_samples(const PhotonCounts& counts, PassImage& image) {
    for (std::size_t i = 0; i < counts.size(); ++i)
        image.add_term(Aov::samples, i, 0, {static_cast<std::int64_t>(counts[i].load()), 0});
}

}  // namespace sunfleck::engine
