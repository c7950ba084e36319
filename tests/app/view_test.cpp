// `render --view`: its address, its page, and a render that does not mind being watched.
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
using testing_support::operator+;

class View : public ViewTest {};

TEST_F(View, shows_a_render_until_it_ends_and_leaves_its_bytes_alone) {
    ASSERT_EQ(run(words({"--passes", "12", "-o", "plain.exr", "--quiet"})).code, 0);
    Process process(path(""), words({"--passes", "12", "-o", "x.exr", "--view"}));
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    const std::string texts = viewer.receive_until();
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(texts.find("\"scene\":\"room.pbrt\""), std::string::npos) << texts;
    EXPECT_NE(texts.find("\"stage\":\"ended\""), std::string::npos) << texts;
    EXPECT_NE(texts.find("\"passes\":12"), std::string::npos) << texts;
    EXPECT_EQ(read_text(path("x.exr")), read_text(path("plain.exr")));
}

TEST_F(View, stays_until_the_user_ends_it) {
    Process process(path(""), words({"--passes", "2", "-o", "x.exr", "--view", "--view-stay"}));
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    EXPECT_NE(viewer.receive_until("\"ended\"").find("\"ended\""), std::string::npos);
    EXPECT_TRUE(exists("x.exr"));
    const std::string picture = ask(at.port, request("GET", "/picture?token=" + at.token));
    EXPECT_EQ(body_of(picture).size(), 3U * 2 * 32 * 32) << status_of(picture);
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 0);
}

TEST_F(View, can_end_a_render_that_keeps_its_picture) {
    Process process(path(""), words({"--passes", "1000000", "-o", "x.exr", "--view"}));
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    EXPECT_NE(viewer.receive_until("\"passes\":3").find("\"passes\":3"), std::string::npos);
    const std::string stop =
        request("POST", "/stop?token=" + at.token, "127.0.0.1", "Content-Length: 0\r\n");
    EXPECT_EQ(status_of(ask(at.port, stop)), 200);
    ask(at.port, stop);  // twice, by two viewers: the second must not lose the picture
    EXPECT_EQ(process.wait().code, 130);
    EXPECT_TRUE(exists("x.exr"));
}

TEST_F(View, says_its_address_alone_before_it_reads_the_scene_but_not_when_quiet) {
    const auto said = [&](const Words& more) {
        return run(Words{"render", "nowhere.pbrt", "--view"} + more).err;
    };
    const std::string warnings = said({"--log-level", "warning"});
    EXPECT_TRUE(warnings.starts_with("http://127.0.0.1:")) << warnings;
    EXPECT_GT(Address(warnings.substr(0, warnings.find('\n'))).port, 0);
    EXPECT_EQ(said({"--quiet"}).find("http"), std::string::npos);
}

TEST_F(View, shows_a_finished_picture_with_its_layers_until_the_user_ends_it) {
    ASSERT_EQ(run(words({"--passes", "2", "-o", "x.exr", "--aovs", "depth", "--quiet"})).code, 0);
    Process process(path(""), {"view", "x.exr"});
    const Address at = address();
    const Connection viewer(at.port);
    viewer.send(request("GET", "/texts?token=" + at.token));
    const std::string text = viewer.receive_until("\"ended\"");
    EXPECT_NE(text.find(R"("layers":["picture","depth","error"])"), std::string::npos) << text;
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 0);
    const Ran none = run({"view", "room.pbrt"});
    EXPECT_EQ(none.code, 2);
    EXPECT_NE(none.err.find("room.pbrt"), std::string::npos) << none.err;
}

TEST_F(View, is_needed_by_what_goes_with_it) {
    for (const Words& flag : {Words{"--view-open"}, Words{"--view-stay"},
                              Words{"--view-host", "::1"}, Words{"--view-against", "x.exr"}}) {
        const Ran ran = render(flag);
        EXPECT_EQ(ran.code, 2) << flag[0];
        EXPECT_NE(ran.err.find("--view"), std::string::npos) << ran.err;
    }
}

}  // namespace
}  // namespace sunfleck::engine
