// Other views of a renderer: what stays of crop and picture.
#include "library/support.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace sunfleck {
namespace {

using testing_support::ball;
using testing_support::green;
using testing_support::quick_settings;
using testing_support::rendered;

std::vector<float> pictured(Renderer& renderer) {
    renderer.step(5);
    return green(renderer.picture());
}

TEST(RenderSession, keeps_a_crop_by_way_of_a_small_picture) {
    Renderer renderer(ball(), quick_settings().set("resolution", "16x16"));
    renderer.set_crop({{3, 4, 3, 4}});
    renderer.set_resolution(4, 4);
    EXPECT_EQ(renderer.picture().width(), 1);
    renderer.set_resolution(32, 32);
    EXPECT_EQ(renderer.picture().width(), 2);
    renderer.set_resolution(16, 16);
    EXPECT_EQ(pictured(renderer),
              rendered(ball(), quick_settings().set("resolution", "16x16").set("crop", "3,4,3,4")));
}

TEST(RenderSession, keeps_a_crop_window_at_each_size) {
    const char* const window = "0.25,0.5,0.25,0.5";
    Renderer renderer(ball(), quick_settings().set("cropwindow", window));
    renderer.set_resolution(3, 3);
    renderer.set_resolution(40, 40);
    EXPECT_EQ(
        pictured(renderer),
        rendered(ball(), quick_settings().set("resolution", "40x40").set("cropwindow", window)));
    renderer.set_crop({});
    renderer.set_resolution(20, 20);
    EXPECT_EQ(renderer.picture().width(), 20);
}

TEST(RenderSession, refuses_a_shutter_in_words) {
    Renderer renderer(ball(), quick_settings());
    try {
        renderer.set_camera("perspective", {{"float shutterclose", 0.25}}, Transform());
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("exposure"), std::string::npos) << error.what();
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// In a process whose memory is limited.
[[noreturn]] void change_to_a_view_without_room() {
    Renderer renderer(ball(), quick_settings());
    const std::vector<float> before = pictured(renderer);
    const ::rlimit limit{::rlim_t{3} << 30U, ::rlim_t{3} << 30U};
    ::setrlimit(RLIMIT_AS, &limit);
    bool is_refused = false;
    try {
        renderer.set_resolution(16384, 16384);
    } catch (const Error& error) {
        is_refused = error.code() == ErrorCode::machine;
    }
    const bool is_as_before = green(renderer.picture()) == before &&
                              renderer.progress().passes == 5 && !renderer.statistics().empty();
    std::_Exit(is_refused && is_as_before ? 0 : 1);
}

TEST(RenderSessionDeathTest, has_its_old_view_where_memory_lacks_for_another) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(change_to_a_view_without_room(), testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace sunfleck
