// Signals that ask a command to end: the first ends it after the step that runs, or at once where
// nothing would be lost; the next ends it at once.
#pragma once

#include <atomic>
#include <functional>

namespace sunfleck::engine {

/// How the program answers signals. A null text means that nothing is printed.
struct InterruptAnswer {
    const char* first = nullptr;  // printed after the first signal: what is still done
    const char* lost = nullptr;   // printed after the second signal: what is lost
    bool ends = false;            // the first one ends the program: there is nothing to finish
};

/// While it lives, SIGINT, SIGTERM and SIGHUP set interrupted(), or end the program (130) if the
/// answer says so. A second SIGINT or SIGTERM ends it, if it comes at least a second after the
/// first: a terminal that closes sends several, and impatient fingers do. Signals that were ignored
/// before stay ignored, as `nohup` and shells want it.
class InterruptGuard {
public:
    /// @param answer  outlives the guard, as those below do.
    explicit InterruptGuard(const InterruptAnswer& answer);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    InterruptGuard(InterruptGuard&&) = delete;
    InterruptGuard& operator=(InterruptGuard&&) = delete;

    /// Sets how signals are answered from now on.
    static void set_answer(const InterruptAnswer& answer);
    static const std::atomic<bool>& interrupted();
    /// Calls task(), which a second signal does not cut short (so that it leaves no half of a
    /// file); the program ends after it.
    static void finish_first(const std::function<void()>& task);
};

}  // namespace sunfleck::engine
