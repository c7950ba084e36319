// Runs a program as a child process to its end, with its output in a file.
#pragma once

#include <atomic>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Runs words[0] with the other words as arguments; standard output and error go to the file `log`.
/// @param interrupted  polled several times per second; when set, the child receives SIGINT, and
/// its end is still waited for. May be null.
/// @return its exit code; 128 + the signal's number if a signal ended it.
/// @throws Error  if it cannot be started.
int run_child(const std::vector<std::string>& words, const std::string& log,
              const std::atomic<bool>* interrupted);

}  // namespace sunfleck::engine
