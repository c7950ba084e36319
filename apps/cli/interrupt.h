// Ctrl-C: the first asks the render to end after the pass that runs, the second ends at once.
#pragma once

#include <atomic>
#include <functional>

namespace sunfleck {

/// While it lives, SIGINT and SIGTERM set interrupted(); a second one ends the program (130).
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    InterruptGuard(InterruptGuard&&) = delete;
    InterruptGuard& operator=(InterruptGuard&&) = delete;

    static const std::atomic<bool>& interrupted();
    /// Calls task(), which a second signal does not cut short (so that it leaves no half of a
    /// file); the program ends after it.
    static void finish_first(const std::function<void()>& task);
};

}  // namespace sunfleck
