// The clock that stands while something is done aside. Only differences of clocks are asserted.
#include "core/stopwatch.h"

#include <gtest/gtest.h>

#include <thread>

namespace sunfleck::engine {
namespace {

using namespace std::chrono_literals;

TEST(WorkClock, stands_while_something_is_done_aside) {
    const Stopwatch wall;
    WorkClock clock;
    clock.aside([] { std::this_thread::sleep_for(20ms); });
    EXPECT_GE(wall.seconds() - clock.seconds(), 0.02);
    const double before = clock.seconds();
    std::this_thread::sleep_for(5ms);
    EXPECT_GE(clock.seconds() - before, 0.005);
}

TEST(WorkClock, does_not_charge_the_processor_s_time_either) {
    WorkClock clock;
    const double start = process_cpu_seconds();
    clock.aside([&] {
        while (process_cpu_seconds() - start < 0.01) {
        }
    });
    EXPECT_GE(process_cpu_seconds() - clock.cpu_seconds(), 0.0099);
    EXPECT_GE(clock.cpu_seconds(), 0);
}

}  // namespace
}  // namespace sunfleck::engine
