// A program as a child process: run to its end, its words kept in a file.
#pragma once

#include <atomic>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Runs words[0] with the other words, standard output and error going to the file `log`.
/// @param interrupted  asked some times a second: when set, the child is told (SIGINT) and waited
///                     for all the same. May be null.
/// @return its exit code; 128 + the signal's number when one ended it.
/// @throws Error if it cannot be started.
int run_child(const std::vector<std::string>& words, const std::string& log,
              const std::atomic<bool>* interrupted);

}  // namespace sunfleck::engine
