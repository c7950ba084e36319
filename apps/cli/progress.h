// The progress line: how far the picture is, how good, and how long it will take.
//
// On a terminal it rewrites itself as time goes on and fits the terminal's width; elsewhere it is a
// line in ten seconds. A thread of its own draws it: a terminal that takes no text holds up nothing
// else.
#pragma once

#include "core/stopwatch.h"
#include "render/render_hooks.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace sunfleck::engine {

/// In whole seconds: 7 s, 3m12s, 2h05m.
std::string duration_text(double seconds);
/// What a picture is, with its error where that is known: 64 passes, 11 s, error 1.9% (95% of
/// blocks).
std::string state_text(std::uint64_t passes, double seconds, std::optional<TargetError> error);

class ProgressLine {
public:
    /// Until show() is called, the scene is being read.
    /// @param wanted  if not, nothing is said, whatever the terminal.
    explicit ProgressLine(bool wanted);
    /// Accepts the line away, so that what is said next stands on its own.
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ProgressLine(ProgressLine&&) = delete;
    ProgressLine& operator=(ProgressLine&&) = delete;

    void show(const Progress& progress);

private:
    struct Shown {
        Progress progress;
        Stopwatch since;
    };

    void draw_until_over();
    std::string text_now(std::size_t width) const;

    std::mutex mutex_;  // of what follows
    std::condition_variable changed_;
    std::optional<Shown> shown_;
    Stopwatch reading_;
    bool is_over_ = false;
    std::thread thread_;
};

}  // namespace sunfleck::engine
