// The program under test as a process, with a limit of its processor time.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine::differential {

using Words = std::vector<std::string>;

/// How a process ended.
struct Ended {
    int code = 0;          // exit code; 128 + signal where one killed it
    bool is_late = false;  // it was killed for its time
    std::string said;      // standard output and standard error
    double seconds = 0;    // processor time

    /// Exit code, or signal, and the first line that was said.
    std::string text() const;
};

class Program {
public:
    /// @param seconds  processor time that a run may take; ten times as much on the clock.
    Program(std::string path, int seconds) : path_(std::move(path)), seconds_(seconds) {}

    /// Runs the program to its end.
    /// @param interrupt_after  a SIGINT is sent after this time, if it still runs.
    /// @throws std::system_error if no process can be started.
    Ended run(const std::string& folder, const Words& words,
              std::optional<std::chrono::milliseconds> interrupt_after = {}) const;

private:
    std::string path_;
    int seconds_;
};

}  // namespace sunfleck::engine::differential
