// Runs a program as a child process to its end, with its output in a file.
#pragma once

#include <atomic>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct ChildEnd {
    int code = 0;            // exit code; 128 + the signal's number if a signal ended it
    double cpu_seconds = 0;  // of all its threads
};

/// Runs words[0] with the other words as arguments; standard output and error go to the file `log`.
/// @param interrupted  polled several times per second; when set, the child receives SIGINT, and
/// its end is still waited for. May be null.
/// @throws Error  if it cannot be started.
ChildEnd run_child(const std::vector<std::string>& words, const std::string& log,
                   const std::atomic<bool>* interrupted);

/// @throws Error  with the last line of the log, if a render did not end well.
void check_render(const ChildEnd& end, const std::string& log);

}  // namespace sunfleck::engine
