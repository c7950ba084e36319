// The progress line: passes, paths a second, error, time left. On a terminal it rewrites itself;
// elsewhere it is silent.
#pragma once

#include "render/progressive.h"

#include <chrono>
#include <string>

namespace sunfleck {

/// Rounded up: 7s, 3m12s, 2h05m.
std::string duration_text(double seconds);

class ProgressLine {
public:
    /// @param wanted  if not, nothing is said, whatever the terminal.
    explicit ProgressLine(bool wanted);
    /// Ends the line, so that what is printed next stands on its own.
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ProgressLine(ProgressLine&&) = delete;
    ProgressLine& operator=(ProgressLine&&) = delete;

    void show(const Progress& progress);

private:
    bool shown_ = false;
    bool terminal_ = false;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace sunfleck
