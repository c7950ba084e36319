// A limit of time, or a signal, ends a render without what has not been finished; what is finished
// does not know that there was one.
#include "core/stopwatch.h"
#include "render/progressive.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

class Deadlines : public ::testing::Test {
protected:
    Deadlines() {
        settings_.photon.paths_per_pass = 2000;
        stop_.end_pass = 20;
    }

    RenderResult rendered(const RenderHooks& hooks = {}) const {
        return render({scene_, settings_, stop_}, hooks);
    }

    Scene scene_ =
        scene_of(view("0 -4 2  0 0 0.5  0 0 1", 40, 8) + diffuse("0.5 0.5 0.5") +
                 quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0") + quad("-3 3 0  3 3 0  3 3 3  -3 3 3") +
                 "LightSource \"point\" \"point3 from\" [0 0 2]\n");
    RenderSettings settings_;
    StopSettings stop_;
};

TEST_F(Deadlines, leave_no_time_for_learning_and_there_is_a_pass_without_it) {
    stop_.seconds = -10;  // over before it begins
    const RenderResult result = rendered();
    EXPECT_TRUE(result.is_unlearned);
    settings_.photon.sampler = PhotonSampler::uniform;
    stop_ = {};
    stop_.end_pass = 1;
    const RenderResult plain = rendered();
    EXPECT_FALSE(plain.is_unlearned);
    EXPECT_TRUE(result.film.sums() == plain.film.sums());
}

/// It is to go on, and so must be of this render.
TEST_F(Deadlines, do_not_cut_the_first_pass_of_a_checkpoint_short) {
    stop_.seconds = -10;
    RenderHooks hooks;
    hooks.save = [](const RenderState&) {};
    const RenderResult result = rendered(hooks);
    EXPECT_FALSE(result.is_unlearned);
    EXPECT_EQ(result.film.pass_count(), 1U);
}

TEST_F(Deadlines, have_seconds_left_that_are_never_negative) {
    stop_.seconds = 1e-9;
    RenderHooks hooks;
    int reports = 0;
    hooks.report = [&](const Progress& p) {
        ++reports;
        if (p.seconds_left) {
            EXPECT_GE(*p.seconds_left, 0);
        }
    };
    EXPECT_EQ(rendered(hooks).film.pass_count(), 1U);
    EXPECT_EQ(reports, 3) << "before and after learning, and after the pass";
}

/// Passes that cannot end in time are not begun.
TEST_F(Deadlines, end_within_a_second_of_time_asked_for) {
    settings_.photon.paths_per_pass = 20'000;
    stop_.seconds = 0.2;
    stop_.end_pass = 10'000;
    const Stopwatch watch;
    const RenderResult result = rendered();
    EXPECT_LT(result.total_seconds, 1.2);
    EXPECT_LT(watch.seconds(), 2);
    EXPECT_GE(result.film.pass_count(), 1U);
}

/// Passes of the second epoch begin with learning.
TEST_F(Deadlines, interrupts_end_learning_and_leave_the_passes_before) {
    std::atomic<bool> interrupted = false;
    RenderHooks hooks;
    hooks.interrupted = &interrupted;
    hooks.report = [&](const Progress& p) {
        if (p.is_learning && p.passes == 16) interrupted = true;
    };
    const RenderResult result = rendered(hooks);
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(result.film.pass_count(), 16U);
    stop_.end_pass = 16;
    EXPECT_TRUE(result.film.sums() == rendered().film.sums());
}

TEST_F(Deadlines, are_not_waited_for_where_every_picture_is_black) {
    stop_ = {};
    stop_.seconds = 60;
    const Scene no_light = scene_of(view("0 -4 2  0 0 0.5  0 0 1", 40, 8) + diffuse("0.5 0.5 0.5") +
                                    quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0"));
    const Scene no_power =
        scene_of(view("0 -4 2  0 0 0.5  0 0 1", 40, 8) + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0") +
                 "LightSource \"point\" \"float scale\" 0\n");
    const Scene looks_away =
        scene_of(view("0 -4 2  0 -9 2  0 0 1", 40, 8) + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0") +
                 "LightSource \"point\" \"point3 from\" [0 0 2]\n");
    const auto passes = [&](const Scene& scene) {
        return render({scene, settings_, stop_}, RenderHooks{}).film.pass_count();
    };
    EXPECT_EQ(passes(no_light), 1U);
    EXPECT_EQ(passes(no_power), 1U);
    EXPECT_EQ(passes(looks_away), 16U);
    settings_.aovs[static_cast<std::size_t>(Aov::normal)] = true;
    EXPECT_EQ(passes(no_light), 16U) << "whose normals are seen";
    stop_.end_pass = 3;
    EXPECT_EQ(passes(no_light), 3U) << "as many as are asked for";
}

}  // namespace
}  // namespace sunfleck::engine
