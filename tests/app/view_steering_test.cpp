// A render that viewers steer: it does what they want, and its picture has the same bytes.
#include "app/view_support.h"

namespace sunfleck::engine {
namespace {

using testing_support::Address;
using testing_support::ask;
using testing_support::body_of;
using testing_support::Connection;
using testing_support::Process;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::request;
using testing_support::status_of;
using testing_support::ViewTest;
using testing_support::Words;

class ViewSteering : public ViewTest {
protected:
    static int post(const Address& at, const std::string& path) {
        const auto [name, more] = std::pair(path.substr(0, path.find('?')), path.find('?'));
        const std::string rest = more == std::string::npos ? "" : "&" + path.substr(more + 1);
        return status_of(ask(at.port, request("POST", "/" + name + "?token=" + at.token + rest,
                                              "127.0.0.1", "Content-Length: 0\r\n")));
    }
    static std::string see(const Connection& viewer, const std::string& mark) {
        const std::string text = viewer.receive_until(mark);
        EXPECT_NE(text.find(mark), std::string::npos) << mark;
        return text;
    }
};

TEST_F(ViewSteering, looks_aside_and_pauses_leave_the_bytes_alone) {
    ASSERT_EQ(run(words({"--passes", "24", "-o", "plain.exr", "--quiet"})).code, 0);
    Process process(path(""), words({"--passes", "24", "-o", "x.exr", "--view"}));
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    see(viewer, "\"can_be_steered\":true");
    EXPECT_EQ(post(at, "look?region=0.25,0.75,0.5,1"), 200) << "while it learns, or later";
    see(viewer, "\"region\":[8,24,16,32]");
    EXPECT_EQ(post(at, "look?yaw=0.2&moving=1"), 200);
    see(viewer, "\"is_moved\":true");
    EXPECT_EQ(post(at, "look?turn=0.1&nearer=0.5"), 200);
    EXPECT_EQ(post(at, "back"), 200);
    see(viewer, "\"look\":null");
    see(viewer, "\"passes\":2");
    EXPECT_EQ(post(at, "pause?on=1"), 200);
    see(viewer, "\"is_paused\":true");
    EXPECT_EQ(post(at, "look?turn=0.1"), 200) << "in a pause";
    see(viewer, "\"is_moved\":true");
    EXPECT_EQ(post(at, "back"), 200);
    EXPECT_EQ(post(at, "pause?on=0"), 200);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(read_text(path("x.exr")), read_text(path("plain.exr")));
}

TEST_F(ViewSteering, viewers_choose_when_it_ends) {
    Process process(path(""), words({"--passes", "1000000", "-o", "x.exr", "--view"}));
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    see(viewer, "\"can_be_steered\":true");
    EXPECT_EQ(post(at, "ends?seconds=0.01"), 200);
    see(viewer, "\"end_seconds\":0.01");
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 0) << "it has ended by itself: " << ran.err;
    EXPECT_TRUE(exists("x.exr"));
}

TEST_F(ViewSteering, a_signal_ends_a_look_and_keeps_the_render) {
    Process process(path(""), words({"--passes", "1000000", "-o", "x.exr", "--view"}));
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    see(viewer, "\"passes\":1,");
    EXPECT_EQ(post(at, "look?region=0,0.5,0,0.5"), 200);
    see(viewer, "\"region\":[0,16,0,16]");
    process.send(SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 130) << ran.err;
    EXPECT_TRUE(exists("x.exr"));
}

TEST_F(ViewSteering, a_finished_render_can_still_be_looked_at) {
    Process process(path(""), words({"--passes", "1", "-o", "x.exr", "--view", "--view-stay"}));
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    see(viewer, "\"stage\":\"ended\"");
    EXPECT_EQ(post(at, "look?region=0,0.5,0,1"), 200);
    const std::string text = see(viewer, "\"region\":[0,16,0,32]");
    EXPECT_EQ(text.find("\"fault\":\"x"), std::string::npos);
    EXPECT_EQ(post(at, "back"), 200);
    see(viewer, "\"look\":null");
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 0);
}

TEST_F(ViewSteering, a_picture_to_compare_with_is_served_beside_the_render) {
    ASSERT_EQ(run(words({"--passes", "1", "-o", "before.exr", "--quiet"})).code, 0);
    Process process(path(""), {"view", "before.exr", "--against", "before.exr"});
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    see(viewer, "\"earlier\":\"before.exr\"");
    const auto picture = [&](const std::string& of) {
        return body_of(ask(at.port, request("GET", "/picture?token=" + at.token + "&of=" + of)));
    };
    EXPECT_EQ(picture("earlier"), picture("render"));
    EXPECT_EQ(picture("earlier").size(), 3U * 2 * 32 * 32);
    const std::string file = ask(at.port, request("GET", "/file?token=" + at.token));
    EXPECT_EQ(body_of(file), read_text(path("before.exr"))) << "as it was read";
    EXPECT_EQ(post(at, "look?turn=1"), 409);
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 0);
    const Ran none = run({"view", "before.exr", "--against", "nowhere.exr"});
    EXPECT_EQ(none.code, 2);
    EXPECT_NE(none.err.find("nowhere.exr"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace sunfleck::engine
