// Memory that a decoded picture takes, asked about before it is taken.
#pragma once

#include "core/memory_room.h"

#include <cstdint>
#include <string>

namespace sunfleck::engine {

/// What is wrong with a picture that takes so many bytes while it is decoded: empty, or that they
/// are more than is free.
inline std::string fault_of_size(std::uint64_t bytes) {
    constexpr std::uint64_t kMebi = 1U << 20U;
    constexpr std::uint64_t kSmall = 64 * kMebi;  // less is not worth the question
    if (bytes <= kSmall || bytes <= free_memory()) return "";
    return "its pixels take " + std::to_string(bytes / kMebi) + " MiB, more than is free";
}

}  // namespace sunfleck::engine
