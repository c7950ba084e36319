// Clocks and medians of the benchmarks.
//
// Wall time says what a user waits for; the processor time of the whole process says what the work
// costs, and is hardly disturbed by other programs on the machine.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace sunfleck::engine::bench {

/// Seconds.
struct Elapsed {
    double wall = 0;
    double cpu = 0;  // of all threads together
};

/// Runs work() once.
template <class Work>
Elapsed time_of(const Work& work) {
    const auto cpu_now = [] {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    };
    const auto wall = std::chrono::steady_clock::now();
    const double cpu = cpu_now();
    work();
    const double cpu_used = cpu_now() - cpu;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - wall;
    return {passed.count(), cpu_used};
}

/// @param values  at least one.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace sunfleck::engine::bench
