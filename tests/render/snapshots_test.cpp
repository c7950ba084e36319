// Snapshots of a render under way: when they are taken, and that their time does not count.
#include "core/stopwatch.h"
#include "render/progressive.h"
#include "support/renders.h"

#include <gtest/gtest.h>

#include <thread>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers
using namespace std::chrono_literals;

/// Passes in the film at each snapshot.
std::vector<std::uint64_t> snapshots_of(std::uint32_t first, std::uint32_t end) {
    const Scene scene = scene_of(view("0 -4 2  0 0 0.5  0 0 1", 40, 4) + diffuse("1 1 1") +
                                 quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0"));
    RenderSettings settings;
    settings.photon.paths_per_pass = 10;
    StopSettings stop;
    stop.first_pass = first;
    stop.end_pass = end;
    std::vector<std::uint64_t> passes;
    RenderHooks hooks;
    hooks.snapshot = [&](const RenderResult& so_far) {
        passes.push_back(so_far.film.pass_count());
        std::this_thread::sleep_for(10ms);
    };
    const Stopwatch wall;
    const RenderResult result = render({scene, settings, stop}, hooks);
    EXPECT_GE(wall.seconds() - result.total_seconds, 0.01 * static_cast<double>(passes.size()));
    return passes;
}

TEST(Snapshots, are_taken_at_powers_of_two_and_at_the_end) {
    using Passes = std::vector<std::uint64_t>;
    EXPECT_EQ(snapshots_of(0, 1), (Passes{1}));
    EXPECT_EQ(snapshots_of(0, 8), (Passes{1, 2, 4, 8}));
    EXPECT_EQ(snapshots_of(0, 11), (Passes{1, 2, 4, 8, 11}));
    EXPECT_EQ(snapshots_of(5, 8), (Passes{1, 2, 3}));
}

}  // namespace
}  // namespace sunfleck::engine
