// Signals that ask a command to end: the first ends it after the step that runs, the next at once.
#pragma once

#include <atomic>
#include <functional>

namespace sunfleck {

/// What is said when a signal comes; null: nothing. The texts outlive the guard.
struct InterruptWords {
    const char* first = nullptr;  // what is done before the end
    const char* lost = nullptr;   // what a second one has lost
};

/// While it lives, SIGINT, SIGTERM and SIGHUP set interrupted(). A second SIGINT or SIGTERM ends
/// the program (130), if it comes at least a second after the first: a terminal that closes sends
/// several, and impatient fingers do. Signals that were ignored before stay ignored, as `nohup` and
/// shells want it.
class InterruptGuard {
public:
    explicit InterruptGuard(const InterruptWords& words);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    InterruptGuard(InterruptGuard&&) = delete;
    InterruptGuard& operator=(InterruptGuard&&) = delete;

    /// What is to be said from now on.
    static void set_words(const InterruptWords& words);
    static const std::atomic<bool>& interrupted();
    /// Calls task(), which a second signal does not cut short (so that it leaves no half of a
    /// file); the program ends after it.
    static void finish_first(const std::function<void()>& task);
};

}  // namespace sunfleck
