// Pacing: something that is done now and then costs at most a fiftieth of the time.
#pragma once

#include <algorithm>
#include <chrono>

namespace sunfleck::engine {

class Pacing {
public:
    /// Returns whether it may be done again.
    bool is_due() const { return Clock::now() >= next_; }
    /// Does it now; the next time is due after fifty times of what it took.
    /// @param besides  what it costs beside that time.
    template <class Task>
    void run(const Task& task, std::chrono::nanoseconds besides = {}) {
        constexpr int kOftenOverCost = 50;
        constexpr std::chrono::milliseconds kLeastPause(200);
        const Clock::time_point begin = Clock::now();
        task();
        const Clock::time_point end = Clock::now();
        const Clock::duration cost = end - begin + besides;
        next_ = end + std::max<Clock::duration>(kLeastPause, kOftenOverCost * cost);
    }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point next_{};
};

}  // namespace sunfleck::engine
