// Check of the memory that a decoded image needs, before it is allocated.
#pragma once

#include "core/memory_room.h"

#include <cstdint>
#include <string>

namespace sunfleck::engine {

/// Returns what is wrong with an image that needs so many bytes to decode: empty, or that the bytes
/// exceed free memory.
inline std::string fault_of_size(std::uint64_t bytes) {
    constexpr std::uint64_t kMebi = 1U << 20U;
    constexpr std::uint64_t kSmall = 64 * kMebi;  // smaller images are decoded without asking
    if (bytes <= kSmall || bytes <= free_memory()) return "";
    return "its pixels take " + std::to_string(bytes / kMebi) + " MiB, more than is free";
}

}  // namespace sunfleck::engine
