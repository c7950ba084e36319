// LiveWishes: what viewers want of a render, from their threads to the one that renders.
//
// A wish replaces the one before: viewers share one render.
#pragma once

#include "live/look.h"

#include <atomic>
#include <mutex>
#include <optional>

namespace sunfleck::engine {

/// When a render is to end: at an error, after a time, or at what comes first; if neither is set,
/// when somebody stops it.
struct LiveEnds {
    std::optional<double> error;    // relative, as --target-error has it
    std::optional<double> seconds;  // on the wall, from the beginning of the render
};

class LiveWishes {
public:
    // Viewers. Returns whether the render takes such wishes.
    bool look(const Look& look);
    bool end_look();
    bool pause(bool is_paused);
    bool end_at(const LiveEnds& ends);

    // The render.
    /// From now on wishes are taken.
    void accept();
    /// Set while viewers want another look than the one that was taken last.
    const std::atomic<bool>& wants_change() const { return wants_change_; }
    /// Returns what is to be seen aside from now on; nothing: the render itself.
    std::optional<Look> take_look();
    bool is_paused() const { return is_paused_; }
    bool wants_other_ends() const;
    /// Returns other ends, once.
    std::optional<LiveEnds> take_ends();

private:
    bool set_look(const std::optional<Look>& look);

    mutable std::mutex mutex_;  // of what follows up to the empty line
    bool is_accepting_ = false;
    std::optional<Look> look_;
    std::optional<LiveEnds> ends_;

    std::atomic<bool> wants_change_{false};
    std::atomic<bool> is_paused_{false};
};

}  // namespace sunfleck::engine
