// Time on the wall and of the processors, in seconds. For reports and limits alone: no pixel may
// depend on it.
#pragma once

#include <chrono>
#include <ctime>

namespace sunfleck::engine {

class Stopwatch {
public:
    /// Since it was made.
    double seconds() const { return since(start_, std::chrono::steady_clock::now()); }

    /// Since the last lap, or since it was made.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double passed = since(last_, now);
        last_ = now;
        return passed;
    }

private:
    using Time = std::chrono::steady_clock::time_point;

    static double since(Time from, Time to) {
        return std::chrono::duration<double>(to - from).count();
    }

    Time start_ = std::chrono::steady_clock::now();
    Time last_ = start_;
};

/// Of all threads of this process, since it began.
inline double process_cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The time of the work itself: what is done aside does not count.
class WorkClock {
public:
    double seconds() const { return watch_.seconds() - aside_; }
    /// Of all threads of this process.
    double cpu_seconds() const { return process_cpu_seconds() - start_cpu_ - aside_cpu_; }

    /// Runs task() while the clock stands.
    template <class Task>
    void aside(const Task& task) {
        const Stopwatch watch;
        const double cpu = process_cpu_seconds();
        task();
        aside_ += watch.seconds();
        aside_cpu_ += process_cpu_seconds() - cpu;
    }

private:
    Stopwatch watch_;
    double start_cpu_ = process_cpu_seconds();
    double aside_ = 0;
    double aside_cpu_ = 0;
};

}  // namespace sunfleck::engine
