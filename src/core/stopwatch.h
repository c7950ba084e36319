// Time on the wall, in seconds. For reports and limits alone: no pixel may depend on it.
#pragma once

#include <chrono>

namespace sunfleck {

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

}  // namespace sunfleck
