// The server of a render's page: who is answered, and what.
#include "live/server.h"

#include "live/http.h"

#include <nlohmann/json.hpp>

#include <atomic>
#include <cstring>
#include <vector>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

class LiveServers : public ::testing::Test {
protected:
    std::string path(const std::string& name, const std::string& more = "") const {
        return "/" + name + "?token=" + address_.token + more;
    }
    std::string get(const std::string& path) const {
        return ask(address_.port, request("GET", path));
    }

    static Picture two_pixels() {
        Picture picture{2, 1, {}, {}};
        for (const char* name : {"R", "G", "B", "error.Y"}) picture.add(name);
        picture.channels[0].values = {1e30F, -0.5F};
        picture.channels[3].values = {0.25F, 3};
        return picture;
    }

    std::atomic<int> stops_ = 0;
    std::shared_ptr<LiveBoard> board_ = std::make_shared<LiveBoard>();
    std::shared_ptr<LiveWishes> wishes_ = std::make_shared<LiveWishes>();
    LiveServer server_{board_, wishes_, "", [this] { ++stops_; }};
    Address address_{server_.url()};
};

TEST_F(LiveServers, have_an_address_of_this_machine_with_a_token_of_their_own) {
    EXPECT_GT(address_.port, 0) << server_.url();
    EXPECT_EQ(address_.token.size(), 32U);
    const LiveServer other(std::make_shared<LiveBoard>(), wishes_, "", [] {});
    EXPECT_NE(Address(other.url()).token, address_.token);
}

TEST_F(LiveServers, send_a_page_that_needs_nothing_else) {
    const std::string answer = get(path(""));
    EXPECT_EQ(status_of(answer), 200);
    for (const char* part : {"<canvas", "EventSource", "default-src 'none'", "no-referrer"})
        EXPECT_NE(answer.find(part), std::string::npos) << part;
    EXPECT_EQ(answer.find("<!-- s"), std::string::npos) << "a mark is not filled";
    EXPECT_EQ(body_of(answer).find("http://"), std::string::npos);
    EXPECT_EQ(body_of(answer).find("https://"), std::string::npos);
}

TEST_F(LiveServers, refuse_whoever_has_no_token) {
    std::string wrong = address_.token;
    wrong.back() = wrong.back() == '0' ? '1' : '0';
    for (const std::string& asked :
         {std::string("/"), std::string("/?token="), "/?token=" + wrong,
          "/?token=" + address_.token + "0", std::string("/texts"), std::string("/picture"),
          std::string("/nowhere"), std::string("/../../etc/passwd")})
        EXPECT_EQ(status_of(get(asked)), 403) << asked;
    EXPECT_EQ(status_of(ask(address_.port, request("POST", "/stop"))), 403);
    EXPECT_EQ(stops_, 0);
}

/// A page from elsewhere, and a name from elsewhere that has been led here.
TEST_F(LiveServers, refuse_pages_from_elsewhere) {
    const auto status = [&](const std::string& host, const std::string& more = "") {
        return status_of(ask(address_.port, request("GET", path(""), host, more)));
    };
    EXPECT_EQ(status("localhost:8000"), 200);
    EXPECT_EQ(status("127.0.0.1", "Origin: http://127.0.0.1\r\n"), 200);
    EXPECT_EQ(status("evil.example"), 403);
    EXPECT_EQ(status("127.0.0.1.evil.example"), 403);
    EXPECT_EQ(status("evil.example:127"), 403);
    EXPECT_EQ(status(""), 403);
    EXPECT_EQ(status("127.0.0.1", "Origin: http://evil.example\r\n"), 403);
    EXPECT_EQ(status("127.0.0.1", "Origin: null\r\n"), 403);
}

TEST_F(LiveServers, know_no_files) {
    for (const char* name : {"nowhere", "../CMakeLists.txt", "etc/passwd", "%2e%2e/x"})
        EXPECT_EQ(status_of(get(path(name))), 404) << name;
}

TEST_F(LiveServers, end_a_render_when_they_are_asked_to) {
    EXPECT_EQ(status_of(get(path("stop"))), 404) << "a link must not do it";
    EXPECT_EQ(stops_, 0);
    EXPECT_EQ(status_of(ask(address_.port,
                            request("POST", path("stop"), "127.0.0.1", "Content-Length: 0\r\n"))),
              200);
    EXPECT_EQ(stops_, 1);
}

TEST_F(LiveServers, send_the_upper_halves_of_the_numbers_of_a_layer) {
    EXPECT_EQ(status_of(get(path("picture"))), 204);
    board_->show(two_pixels());
    const std::string answer = get(path("picture", "&layer=picture"));
    EXPECT_NE(answer.find("X-Width: 2\r\n"), std::string::npos) << answer;
    EXPECT_NE(answer.find("X-Number: 1\r\n"), std::string::npos);
    const std::string body = body_of(answer);
    ASSERT_EQ(body.size(), 12U);
    const auto value = [&](std::size_t i) {
        std::uint32_t bits = static_cast<std::uint8_t>(body[2 * i]) << 16U;
        bits |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(body[2 * i + 1])) << 24U;
        float number = 0;
        std::memcpy(&number, &bits, sizeof number);
        return number;
    };
    EXPECT_NEAR(value(0), 1e30, 4e27);
    EXPECT_EQ(value(1), -0.5F);
    EXPECT_EQ(value(2), 0);
    EXPECT_EQ(body_of(get(path("picture", "&layer=error"))).size(), 4U);
    EXPECT_NE(get(path("picture", "&layer=none")).find("X-Layer: picture"), std::string::npos);
}

TEST_F(LiveServers, tell_each_viewer_the_latest_text_and_those_that_follow) {
    board_->tell(R"({"a":1})");
    const Connection one(address_.port);
    one.send(request("GET", path("texts")));
    EXPECT_NE(one.receive_until(R"("status":{"a":1}})").find("text/event-stream"),
              std::string::npos);
    board_->tell(R"({"a":2})");
    EXPECT_NE(one.receive_until(R"({"a":2})").find("id: 2\n"), std::string::npos);
    const Connection late(address_.port);
    late.send(request("GET", path("texts")));
    EXPECT_EQ(late.receive_until(R"({"a":2})").find(R"({"a":1})"), std::string::npos);
    board_->tell(R"({"a":3})");
    board_->close();
    EXPECT_NE(one.receive_until().find(R"({"a":3})"), std::string::npos) << "ends, with the last";
}

/// Garbage, half a request, a head without end, a body without measure, viewers that never read.
TEST_F(LiveServers, go_on_beside_rude_viewers) {
    board_->show(two_pixels());
    board_->tell("{}");
    std::vector<std::unique_ptr<Connection>> open;
    for (const std::string& bytes :
         {std::string("\x16\x03\x01\x02garbage\r\n\r\n"), std::string("GET "),
          "GET " + path("") + " HTTP/1.1\r\nHost: 127.0.0.1\r\n",
          "GET /" + std::string(100'000, 'x') + " HTTP/1.1\r\n\r\n",
          request("POST", path("stop"), "127.0.0.1", "Content-Length: 99999999999\r\n"),
          request("GET", path("texts")), request("GET", path("texts"))}) {
        open.push_back(std::make_unique<Connection>(address_.port));
        open.back()->send(bytes);
    }
    EXPECT_EQ(status_of(get(path("picture"))), 200);
    EXPECT_EQ(stops_, 0);
}

/// A picture that fits in no buffer, read a byte at a time, and a head that comes a byte at a time.
TEST_F(LiveServers, end_whatever_viewers_do) {
    Picture large{2000, 2000, {}, {}};
    for (const char* name : {"R", "G", "B"}) large.add(name);
    board_->show(std::move(large));
    auto server = std::make_unique<LiveServer>(board_, wishes_, "", [] {});
    const Address at(server->url());
    const Connection reader(at.port);
    reader.send(request("GET", "/picture?token=" + at.token));
    EXPECT_EQ(reader.receive(1).size(), 1U);
    const Connection writer(at.port);
    writer.send("GET /");
    std::atomic<bool> ended = false;
    std::thread dawdler([&] {
        while (!ended) {
            writer.send("x");
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    });
    EXPECT_EQ(status_of(ask(at.port, request("GET", "/"))), 403) << "so the others have come";
    const auto begin = std::chrono::steady_clock::now();
    server.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
    ended = true;
    dawdler.join();
}

TEST_F(LiveServers, do_not_let_viewers_take_all_their_workers) {
    board_->tell("{}");
    std::vector<std::unique_ptr<Connection>> viewers;
    for (int i = 0; i < 16; ++i) {
        viewers.push_back(std::make_unique<Connection>(address_.port));
        viewers.back()->send(request("GET", path("texts")));
        ASSERT_FALSE(viewers.back()->receive_until("data: ").empty());
    }
    EXPECT_EQ(status_of(get(path("texts"))), 503);
    EXPECT_EQ(status_of(get(path(""))), 200);
}

}  // namespace
}  // namespace sunfleck::engine
