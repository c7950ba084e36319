// Consecutive numbers of paths.
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

/// How many paths of a pass are traced before what they bring is deposited: as many as keep some
/// threads busy and fit in memory. Each deposit walks over all that is seen, and larger pictures
/// have more paths: so not more often than some times a pass.
/// @param count  of the pass, or of its part.
constexpr std::uint64_t paths_at_once(std::uint64_t count) {
    constexpr std::uint64_t kLeast = std::uint64_t{1} << 19U;
    constexpr std::uint64_t kMostDeposits = 8;
    return kLeast * std::max<std::uint64_t>(
                        1, (count + kMostDeposits * kLeast - 1) / (kMostDeposits * kLeast));
}

}  // namespace sunfleck::engine
