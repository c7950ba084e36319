// Names of this machine that a browser may say.
#include "live/access.h"

#include "live/http.h"
#include "live/server.h"
#include "sunfleck/error.h"

namespace sunfleck::engine {
namespace {

TEST(OwnHosts, are_loopback_where_nothing_else_is_asked_for) {
    for (const char* host : {"127.0.0.1", "127.0.0.1:80", "localhost:1", "[::1]:5"})
        EXPECT_TRUE(is_own_host(host, "")) << host;
    for (const char* host : {"", "192.0.2.1", "example.org", "localhost.example.org", "[::2]:5"})
        EXPECT_FALSE(is_own_host(host, "")) << host;
}

TEST(OwnHosts, are_the_address_that_is_asked_for) {
    EXPECT_TRUE(is_own_host("192.0.2.1:80", "192.0.2.1"));
    EXPECT_TRUE(is_own_host("[2001:db8::1]:80", "2001:db8::1"));
    EXPECT_FALSE(is_own_host("192.0.2.2:80", "192.0.2.1"));
    EXPECT_FALSE(is_own_host("example.org", "192.0.2.1"));
}

/// A name from elsewhere that has been led here is none of them; an address cannot be led.
TEST(OwnHosts, of_all_addresses_are_numbers_and_the_name_of_the_machine) {
    for (const char* every : {"0.0.0.0", "::"}) {
        EXPECT_TRUE(is_own_host("192.0.2.7:80", every));
        EXPECT_TRUE(is_own_host("[2001:db8::1]:80", every));
        EXPECT_TRUE(is_own_host(url_host(every) + ":80", every));
        EXPECT_FALSE(is_own_host("evil.example:80", every));
        EXPECT_FALSE(is_own_host("1.2.3.4.evil.example", every));
        EXPECT_FALSE(is_own_host("[", every));
        EXPECT_FALSE(is_own_host("", every));
    }
}

TEST(OwnHosts, stand_in_the_address_of_the_page) {
    EXPECT_EQ(url_host(""), "127.0.0.1");
    EXPECT_EQ(url_host("192.0.2.1"), "192.0.2.1");
    EXPECT_EQ(url_host("2001:db8::1"), "[2001:db8::1]");
    EXPECT_FALSE(url_host("0.0.0.0").empty());
}

TEST(LiveServersElsewhere, of_all_addresses_are_reached_by_each_and_still_want_the_token) {
    using testing_support::ask;
    const LiveServer server(std::make_shared<LiveBoard>(), std::make_shared<LiveWishes>(),
                            "0.0.0.0", [] {});
    const std::string url = server.url();
    const std::size_t mark = url.find("/?token=");
    const int port = std::stoi(url.substr(url.rfind(':', mark) + 1));
    const std::string page = "/?token=" + url.substr(mark + 8);
    using testing_support::request;
    using testing_support::status_of;
    EXPECT_EQ(status_of(ask(port, request("GET", page, "192.0.2.1:80"))), 200);
    EXPECT_EQ(status_of(ask(port, request("GET", "/", "192.0.2.1:80"))), 403);
    EXPECT_EQ(status_of(ask(port, request("GET", page, "evil.example"))), 403);
}

TEST(LiveServersElsewhere, of_an_address_that_is_not_the_machines_are_an_error) {
    try {
        const LiveServer server(std::make_shared<LiveBoard>(), std::make_shared<LiveWishes>(),
                                "192.0.2.1", [] {});
        FAIL() << server.url();
    } catch (const Error& fault) {
        EXPECT_NE(std::string(fault.what()).find("--view-host"), std::string::npos) << fault.what();
    }
}

}  // namespace
}  // namespace sunfleck::engine
