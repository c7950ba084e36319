// Renders of the library: same bytes however they are divided, and ends that leave the rest whole.
#include "library/support.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <memory>
#include <stdexcept>
#include <thread>

namespace sunfleck {
namespace {

using testing_support::ball;
using testing_support::green;
using testing_support::kBall;
using testing_support::quick_settings;
using testing_support::rendered;

TEST(Renderer, has_the_same_bytes_however_passes_are_divided_and_with_any_threads) {
    const std::vector<float> expected = rendered(ball(), quick_settings(), 2);
    EXPECT_EQ(rendered(ball(), quick_settings(), 1), expected);
    Renderer renderer(ball(), quick_settings());
    EXPECT_EQ(renderer.step(2), Outcome::finished);
    EXPECT_EQ(renderer.progress().passes, 2U);
    renderer.step(3);
    EXPECT_EQ(green(renderer.picture()), expected);
}

/// A caller's rounding must not show in a picture.
TEST(Renderer, does_not_depend_on_the_modes_of_the_caller) {
    const std::vector<float> expected = rendered(ball(), quick_settings());
    std::fesetround(FE_UPWARD);
    const std::vector<float> rounded = rendered(ball(), quick_settings());
    const int mode = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(rounded, expected);
    EXPECT_EQ(mode, FE_UPWARD);
}

TEST(Renderer, can_be_cancelled_within_a_pass_and_go_on_as_if_it_had_not) {
    Settings settings;
    settings.set("photons-per-pass", 300000).set("passes", 3).set("resolution", "96x64");
    Renderer renderer(ball(), settings);
    renderer.start();
    EXPECT_TRUE(renderer.is_running());
    EXPECT_THROW(renderer.step(), Error);
    renderer.cancel();
    EXPECT_EQ(renderer.wait(), Outcome::cancelled);
    const std::uint32_t done = renderer.progress().passes;
    EXPECT_LT(done, 3U);
    renderer.step(3 - done);
    EXPECT_EQ(green(renderer.picture()), rendered(ball(), settings));
}

TEST(Renderer, shows_pictures_while_it_renders) {
    Renderer renderer(ball(), quick_settings().set("passes", 200));
    std::vector<std::uint32_t> told;
    renderer.start([&](const Progress& progress) { told.push_back(progress.passes); });
    while (renderer.progress().passes < 2) std::this_thread::yield();
    double sum = 0;
    for (const float value : green(renderer.picture())) sum += value;
    EXPECT_GT(sum, 0);
    renderer.cancel();
    renderer.wait();
    EXPECT_GE(told.size(), 2U);
}

TEST(Renderer, hands_on_what_a_callback_throws) {
    Renderer renderer(ball(), quick_settings());
    const auto fail = [](const Progress&) { throw std::runtime_error("enough"); };
    EXPECT_THROW(renderer.step(1, fail), Error);
    renderer.start(fail);
    EXPECT_THROW(renderer.wait(), Error);
    EXPECT_EQ(renderer.step(1), Outcome::finished);
}

TEST(Renderer, says_which_callback_has_thrown) {
    Renderer renderer(ball(), quick_settings());
    const auto words = [&](const Renderer::Report& report) -> std::string {
        try {
            renderer.step(1, report);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    const std::string closed =
        words([](const Progress&) { throw std::runtime_error("window closed"); });
    EXPECT_NE(closed.find("report has thrown: window closed"), std::string::npos) << closed;
    const std::string number = words([](const Progress&) { throw 42; });
    EXPECT_NE(number.find("report has thrown"), std::string::npos) << number;
    renderer.start([](const Progress&) { throw 42; });
    EXPECT_THROW(renderer.wait(), Error);
}

TEST(Renderer, may_be_owned_by_its_own_report) {
    std::weak_ptr<Renderer> watched;
    {
        const auto renderer = std::make_shared<Renderer>(ball(), quick_settings());
        watched = renderer;
        renderer->start([renderer](const Progress&) {});
    }
    while (!watched.expired()) std::this_thread::yield();
}

TEST(Renderer, refuses_to_wait_in_its_own_report_and_on_two_threads) {
    Renderer renderer(ball(), quick_settings());
    bool is_refused = false;
    renderer.start([&](const Progress&) {
        try {
            renderer.wait();
        } catch (const Error&) {
            is_refused = true;
        }
    });
    EXPECT_EQ(renderer.wait(), Outcome::finished);
    EXPECT_TRUE(is_refused);

    std::atomic<bool> may_end{false};
    std::atomic<int> refused{0};
    renderer.start([&](const Progress&) {
        while (!may_end) std::this_thread::yield();
    });
    const auto wait = [&] {
        try {
            renderer.wait();
        } catch (const Error&) {
            ++refused;
            may_end = true;
        }
    };
    std::thread one(wait);
    std::thread other(wait);
    one.join();
    other.join();
    EXPECT_EQ(refused, 1);
}

TEST(Renderer, renders_on_where_more_passes_are_asked_for_than_there_are) {
    Renderer renderer(ball(), quick_settings());
    renderer.step(1);
    const auto cancel_soon = [&](const Progress& progress) {
        if (progress.passes >= 3) renderer.cancel();
    };
    EXPECT_EQ(renderer.step(~std::uint32_t{0}, cancel_soon), Outcome::cancelled);
    EXPECT_GE(renderer.progress().passes, 3U);
}

TEST(Renderer, sees_from_another_place_what_a_scene_with_that_camera_shows) {
    std::string text = kBall;
    text.replace(text.find("0 -6 4 "), 7, "3 -5 2 ");
    text.replace(text.find("\"float fov\" 35"), 14, "\"float fov\" 50");
    Renderer renderer(ball(), quick_settings());
    renderer.step(1);
    renderer.set_camera("perspective", {{"float fov", 50}},
                        Transform::look_at({3, -5, 2}, {0, 0, 0.6}, {0, 0, 1}));
    EXPECT_EQ(renderer.progress().passes, 0U);
    renderer.step(5);
    EXPECT_EQ(green(renderer.picture()),
              rendered(Scene::parse(text, "ball.pbrt"), quick_settings()));
    EXPECT_THROW(renderer.set_camera("perspective", {{"float zoom", 2}}, Transform()), Error);
}

TEST(Renderer, changes_size_and_crop_as_the_settings_would) {
    Renderer renderer(ball(), quick_settings());
    renderer.set_resolution(12, 20);
    renderer.set_crop({{3, 9, 5, 15}});
    renderer.step(5);
    EXPECT_EQ(renderer.picture().width(), 6);
    Settings settings = quick_settings();
    settings.set("resolution", "12x20").set("crop", "3,9,5,15");
    EXPECT_EQ(green(renderer.picture()), rendered(ball(), settings));
    EXPECT_THROW(renderer.set_crop({{0, 13, 0, 1}}), Error);
    EXPECT_THROW(renderer.set_resolution(0, 4), Error);
}

TEST(Renderer, tells_warnings_to_the_log_alone) {
    std::vector<std::string> lines;
    const Settings settings = Settings().set("photon-sampler", "paper").set("passes", 1);
    const Renderer renderer(ball(), settings,
                            {1, [&](Severity, const std::string& line) { lines.push_back(line); }});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NE(lines.front().find("biased"), std::string::npos);
}

TEST(Renderer, says_each_remark_once_however_often_it_renders_to_its_limit) {
    int told = 0;
    Renderer renderer(ball(), quick_settings().set("extrapolate", "on"),
                      {1, [&](Severity, const std::string&) { ++told; }});
    renderer.run();
    EXPECT_EQ(told, 1);
    renderer.run();
    const std::string remark = "not extrapolated";
    const std::string twice = renderer.statistics();
    const std::size_t first = twice.find(remark);
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(twice.find(remark, first + 1), std::string::npos);
}

TEST(Renderer, refuses_settings_that_the_scene_cannot_have) {
    EXPECT_THROW(Renderer(ball(), Settings().set("light-group", "a=7")), Error);
    EXPECT_THROW(Renderer(ball(), Settings().set("isa", "native")), Error);
    EXPECT_THROW(Renderer(ball(), Settings().set("crop", "0,100,0,1")), Error);
}

TEST(Renderer, has_the_statistics_of_the_command_line) {
    Renderer renderer(ball(), quick_settings());
    renderer.run();
    const std::string statistics = renderer.statistics();
    EXPECT_NE(statistics.find("\"visible_photon_ratio\""), std::string::npos);
    EXPECT_NE(statistics.find("\"passes\": 5"), std::string::npos);
    Renderer of_other_bytes(Scene::parse(kBall, "l\xE4t.pbrt"), quick_settings());
    EXPECT_NE(of_other_bytes.statistics().find("t.pbrt"), std::string::npos);
}

}  // namespace
}  // namespace sunfleck
