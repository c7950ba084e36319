// The progress line: passes, error and time left of a render.
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

class ProgressLine {
public:
    /// The line says that the scene is being read, until show() is called.
    /// @param wanted  false: nothing is printed.
    explicit ProgressLine(bool wanted);
    /// Erases the line, so that the next message begins on a line of its own.
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
