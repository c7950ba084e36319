// How much memory this process may still ask for.
#pragma once

#include <cstdint>

namespace sunfleck {

/// Bytes that are free: the least of what the machine has available, what the control groups of
/// this process leave below their limits, and what its limit of address space leaves.
/// Where the system tells none of these, the greatest number there is.
std::uint64_t free_memory();

}  // namespace sunfleck
