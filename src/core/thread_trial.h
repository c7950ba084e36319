// Whether the threads that loops will use can be had, tried before any work.
#pragma once

namespace sunfleck::engine {

/// Starts as many threads as parallel_for may use, all at once, and ends them; then lets the thread
/// library begin. Later on neither can fail in a way that a program survives.
/// @throws MachineFault if the threads cannot all be had.
void try_threads();

}  // namespace sunfleck::engine
