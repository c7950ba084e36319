// Photons that were taken, by pixel, copies counted each: what local radii follow.
//
// Source: M of section 4, Hachisuka and Jensen 2009, "Stochastic Progressive Photon Mapping". Sums
// of integers: the same for any number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace sunfleck {

using PhotonCounts = std::vector<std::atomic<std::uint64_t>>;

}  // namespace sunfleck
