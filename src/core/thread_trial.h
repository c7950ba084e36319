// Checks before any work that the threads for the loops can be created.
#pragma once

namespace sunfleck::engine {

/// Starts as many threads as parallel_for() may use, all at once, and joins them; then starts the
/// thread library. Later failures of either would end the program.
/// @throws MachineFault  if not all threads can be created.
void try_threads();

}  // namespace sunfleck::engine
