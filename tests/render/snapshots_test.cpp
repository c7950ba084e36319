// Snapshots of a render under way: when they are taken, and that their time does not count; what is
// shown to whoever watches it.
#include "core/stopwatch.h"
#include "film/film_picture.h"
#include "render/progressive.h"
#include "render/render_loop.h"
#include "render/trial_picture.h"
#include "support/renders.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
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

/// A floor under a wide lamp: all its light needs no photon.
Scene floor_under_a_lamp() {
    return scene_of(view("0 0 2  0 0 0  0 1 0", 20, 24) + diffuse(".5 .5 .5") +
                    quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
                    "AreaLightSource \"diffuse\"\nReverseOrientation\n" +
                    quad("-9 -9 3  9 -9 3  9 9 3  -9 9 3"));
}

double mean_of(const Picture& picture) {
    const std::vector<float>& green = picture.find("G")->values;
    return std::accumulate(green.begin(), green.end(), 0.0) / static_cast<double>(green.size());
}

/// Wavelengths of single passes differ by some percent.
TEST(Watched, renders_show_a_first_look_and_then_each_pass) {
    const Scene scene = floor_under_a_lamp();
    RenderSettings settings;
    settings.photon.paths_per_pass = 1000;
    settings.transport.max_depth = 2;
    StopSettings stop;
    stop.end_pass = 2;
    std::vector<Picture> looks;
    std::vector<std::uint64_t> passes;
    RenderHooks hooks;
    hooks.preview = [&](const Picture& picture) {
        EXPECT_TRUE(passes.empty());
        looks.push_back(picture);
    };
    hooks.watch = [&](const Film& film) { passes.push_back(film.pass_count()); };
    const RenderResult result = render({scene, settings, stop}, hooks);
    EXPECT_EQ(passes, (std::vector<std::uint64_t>{1, 2}));
    ASSERT_EQ(looks.size(), 1U);
    EXPECT_NEAR(mean_of(looks[0]) / mean_of(film_picture(result.film)), 1, 0.06);
}

/// A caller holds the render up between passes, ends a run, and lets it go on.
TEST(Watched, renders_wait_for_who_steers_them_and_have_the_same_film) {
    const Scene scene = floor_under_a_lamp();
    RenderSettings settings;
    settings.photon.paths_per_pass = 1000;
    StopSettings stop;
    stop.end_pass = 6;
    const RenderResult alone = render({scene, settings, stop}, {});
    RenderLoop loop({scene, settings, stop}, std::nullopt);
    std::vector<std::uint64_t> passes;
    bool is_last = false;
    RenderHooks hooks;
    hooks.goes_on = [&] {
        passes.push_back(loop.result().film.pass_count());
        std::this_thread::sleep_for(20ms);
        is_last = passes.size() == 2;
        return !is_last;
    };
    const Stopwatch wall;
    loop.run(stop, hooks);
    EXPECT_EQ(passes, (std::vector<std::uint64_t>{1, 2}));
    EXPECT_FALSE(loop.result().interrupted);
    EXPECT_GE(wall.seconds() - loop.result().total_seconds, 0.04) << "that time does not count";
    std::atomic<bool> cancelled = true;  // within a pass: it leaves nothing
    RenderHooks cut;
    cut.cancelled = &cancelled;
    loop.run(stop, cut);
    EXPECT_EQ(loop.result().film.pass_count(), 2U);
    loop.run(stop, hooks);
    EXPECT_EQ(loop.result().film.pass_count(), 6U);
    EXPECT_EQ(film_picture(loop.result().film), film_picture(alone.film));
}

/// One path in 3 x 3 pixels, 24 of them a side: 64 paths have a noise of 8%.
TEST(Watched, a_first_look_has_a_pixel_for_each_camera_path) {
    const Scene scene = floor_under_a_lamp();
    const RenderSettings settings;
    const PassScene at_wavelengths(scene, {1, 0});
    const PixelWindow window = window_of(scene.film());
    CameraPass pass{at_wavelengths, settings.transport, settings.camera, window, {1, 0}};
    const double all = mean_of(trial_picture(view_of(pass), window));
    pass.cells = 3;
    const Picture few = trial_picture(view_of(pass), window);
    EXPECT_EQ(few.width, 8);
    EXPECT_EQ(few.height, 8);
    EXPECT_NEAR(mean_of(few) / all, 1, 0.25);
}

}  // namespace
}  // namespace sunfleck::engine
