// Ranges of photon paths.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace sunfleck::engine {

/// Paths begin .. end - 1.
struct PathRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t size() const { return end - begin; }
};

/// Returns how many paths of a pass are traced before their photons are deposited: enough to keep
/// threads busy, and few enough for memory. A deposit visits all visible points, and larger
/// pictures have more paths, so a pass has a limited number of deposits.
/// @param count  paths of the pass, or of its stratum.
constexpr std::uint64_t paths_at_once(std::uint64_t count) {
    constexpr std::uint64_t kLeast = std::uint64_t{1} << 19U;
    constexpr std::uint64_t kMostDeposits = 8;
    return kLeast * std::max<std::uint64_t>(
                        1, (count + kMostDeposits * kLeast - 1) / (kMostDeposits * kLeast));
}

}  // namespace sunfleck::engine
