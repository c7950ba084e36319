// Consecutive numbers of paths.
#pragma once

#include <cstddef>

namespace sunfleck {

/// Paths begin .. end - 1.
struct PathRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t size() const { return end - begin; }
};

}  // namespace sunfleck
