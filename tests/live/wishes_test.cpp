// What viewers ask of a render over the server: looks, pauses, ends, and files.
#include "film/film_picture.h"
#include "film/relight.h"
#include "image/exr.h"
#include "live/http.h"
#include "live/layers.h"
#include "live/server.h"
#include "sunfleck/error.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

Look look_of(const LiveParameters& parameters) {
    return read_look(parameters);
}

TEST(Looks, are_the_render_where_nothing_is_said) {
    const Look look = look_of({{"token", "x"}, {"what", "ever"}});
    EXPECT_FALSE(look.region);
    EXPECT_FALSE(look.focus);
    EXPECT_FALSE(look.is_moving);
    EXPECT_EQ(look.move, CameraMove());
}

TEST(Looks, have_each_number_in_its_place) {
    const Look look = look_of({{"region", "0.25,0.5,0,1"},
                               {"tilt", "0.1"},
                               {"turn", "-2"},
                               {"nearer", "1.5"},
                               {"right", "3"},
                               {"up", "-4"},
                               {"pitch", "0.5"},
                               {"yaw", "6"},
                               {"focus_x", "0.125"},
                               {"focus_y", "1"},
                               {"moving", "1"}});
    EXPECT_EQ(look.region, (std::array<double, 4>{0.25, 0.5, 0, 1}));
    const CameraMove move{
        .tilt = 0.1, .turn = -2, .nearer = 1.5, .beside = {3, -4}, .pitch = 0.5, .yaw = 6};
    EXPECT_EQ(look.move, move);
    EXPECT_EQ(look.focus, Vec2d(0.125, 1));
    EXPECT_TRUE(look.is_moving);
}

TEST(Looks, refuse_what_is_no_number_or_has_no_sense) {
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"turn", "x"},           {"turn", ""},     {"turn", "nan"},        {"turn", "1e9"},
        {"nearer", "inf"},       {"nearer", "21"}, {"region", "0,1,0"},    {"region", "0,2,0,1"},
        {"region", "0,nan,0,1"}, {"up", "1;2"},    {"region", "0,1,0,1,"}, {"right", "-1e300"}};
    for (const auto& [name, text] : wrong)
        EXPECT_THROW(look_of({{name, text}}), Error) << name << "=" << text;
    EXPECT_THROW(look_of({{"focus_x", "0.5"}, {"focus_y", "2"}}), Error);
}

class Wishes : public ::testing::Test {
protected:
    int post(const std::string& name, const std::string& more = "") const {
        return status_of(ask(address_.port, request("POST", path(name, more), "127.0.0.1",
                                                    "Content-Length: 0\r\n")));
    }
    std::string path(const std::string& name, const std::string& more = "") const {
        return "/" + name + "?token=" + address_.token + more;
    }
    std::string get(const std::string& name, const std::string& more = "") const {
        return ask(address_.port, request("GET", path(name, more)));
    }

    std::shared_ptr<LiveBoard> board_ = std::make_shared<LiveBoard>();
    std::shared_ptr<LiveWishes> wishes_ = std::make_shared<LiveWishes>();
    LiveServer server_{board_, wishes_, "", [] {}};
    Address address_{server_.url()};
};

TEST_F(Wishes, are_not_taken_where_nothing_can_be_steered) {
    for (const char* name : {"look", "back", "pause", "ends"}) EXPECT_EQ(post(name), 409) << name;
    EXPECT_FALSE(wishes_->wants_change());
}

TEST_F(Wishes, of_the_latest_look_reach_the_render) {
    wishes_->accept();
    EXPECT_EQ(post("look", "&turn=1"), 200);
    EXPECT_EQ(post("look", "&turn=2&region=0,0.5,0,0.5"), 200);
    EXPECT_TRUE(wishes_->wants_change());
    const auto look = wishes_->take_look();
    ASSERT_TRUE(look);
    EXPECT_EQ(look->move.turn, 2);
    EXPECT_FALSE(wishes_->wants_change());
    EXPECT_EQ(post("look", "&turn=x"), 400) << "and the look stays";
    EXPECT_FALSE(wishes_->wants_change());
    EXPECT_EQ(post("back"), 200);
    EXPECT_TRUE(wishes_->wants_change());
    EXPECT_FALSE(wishes_->take_look());
    EXPECT_EQ(post("back"), 200);
    EXPECT_FALSE(wishes_->wants_change()) << "there is nothing to come back from";
}

TEST_F(Wishes, of_pauses_and_ends_reach_the_render) {
    wishes_->accept();
    EXPECT_EQ(post("pause", "&on=1"), 200);
    EXPECT_TRUE(wishes_->is_paused());
    EXPECT_EQ(post("pause", "&on=0"), 200);
    EXPECT_FALSE(wishes_->is_paused());
    EXPECT_EQ(post("ends", "&error=2%25&seconds=3m"), 200);
    EXPECT_TRUE(wishes_->wants_other_ends());
    const auto ends = wishes_->take_ends();
    ASSERT_TRUE(ends);
    EXPECT_EQ(ends->error, 0.02);
    EXPECT_EQ(ends->seconds, 180);
    EXPECT_FALSE(wishes_->wants_other_ends());
    EXPECT_EQ(post("ends", "&error=&seconds="), 200);
    EXPECT_FALSE(wishes_->take_ends()->error);
    for (const char* wrong : {"&error=x", "&error=-1", "&seconds=tomorrow"})
        EXPECT_EQ(post("ends", wrong), 400) << wrong;
    EXPECT_EQ(status_of(get("look", "&turn=1")), 404) << "a link must not do it";
}

/// Two pixels: light of which "lamp" is a part, and an AOV.
Picture lit_picture() {
    Picture picture{2, 1, {}, {{kLightGroupNames, "lamp"}}};
    for (const char* name : {"R", "G", "B"}) picture.add(name).values = {10, 4};
    for (const char* name : {"lamp.R", "lamp.G", "lamp.B"}) picture.add(name).values = {2, 3};
    picture.add("depth.Z").values = {7, 8};
    return picture;
}

TEST_F(Wishes, of_a_file_get_the_bytes_that_relight_writes) {
    EXPECT_EQ(status_of(get("file")), 404) << "there is no picture yet";
    board_->show(lit_picture());
    EXPECT_EQ(body_of(get("file")), exr_bytes(lit_picture()));
    const Picture dimmed = relit(lit_picture(), {{"lamp", {0.5F, 0.25F, 0}}}, "x").picture;
    EXPECT_EQ(body_of(get("file", "&factor=lamp%3D0.5,0.25,0")), exr_bytes(dimmed));
    EXPECT_EQ(status_of(get("file", "&factor=none%3D1")), 400);
    EXPECT_EQ(status_of(get("file", "&factor=lamp%3Dx")), 400);
}

TEST_F(Wishes, of_a_look_get_a_picture_of_their_own) {
    board_->show(lit_picture());
    EXPECT_EQ(status_of(get("picture", "&of=look")), 204);
    Picture other{1, 1, {}, {}};
    other.add("Y");
    EXPECT_EQ(board_->show(other, LivePlace::look), 2U);
    EXPECT_EQ(body_of(get("picture", "&of=look")).size(), 2U);
    EXPECT_EQ(body_of(get("picture", "&of=render")).size(), 12U);
    board_->clear(LivePlace::look);
    EXPECT_EQ(status_of(get("picture", "&of=look")), 204);
}

TEST_F(Wishes, of_light_without_its_groups_get_the_rest) {
    board_->show(lit_picture());
    const std::string answer = get("picture", "&layer=rest%20of%20light");
    EXPECT_NE(answer.find("X-Layer: rest of light"), std::string::npos) << answer;
    const std::string body = body_of(answer);
    ASSERT_EQ(body.size(), 12U);
    EXPECT_EQ(body.substr(0, 4), std::string("\x00\x41\x80\x3f", 4)) << "8 and 1 as bfloat16";
}

}  // namespace
}  // namespace sunfleck::engine
