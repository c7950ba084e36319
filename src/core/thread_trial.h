// Whether the threads that loops will use can be had, tried before any work.
#pragma once

#include <cstddef>

namespace sunfleck {

/// Starts `count` threads beside the caller's, all at once, and ends them. What starts threads
/// later on cannot tell of its failure in a way that a program survives.
/// @throws MachineFault if they cannot all be started.
void try_threads(std::size_t count);

}  // namespace sunfleck
