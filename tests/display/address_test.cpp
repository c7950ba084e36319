// Addresses of display servers.
#include "display/address.h"

#include "sunfleck/error.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(DisplayAddress, is_a_host_and_a_port) {
    const auto parts = [](const std::string& text) {
        const DisplayAddress address = read_display_address(text, "--display-server");
        EXPECT_EQ(address.text, text);
        return address.host + " " + address.port;
    };
    EXPECT_EQ(parts("127.0.0.1:14158"), "127.0.0.1 14158");
    EXPECT_EQ(parts("localhost:1"), "localhost 1");
    EXPECT_EQ(parts("[::1]:65535"), "::1 65535");
}

TEST(DisplayAddress, of_another_form_is_refused_with_the_right_form) {
    const auto refusal = [](const std::string& text) -> std::string {
        try {
            read_display_address(text, "--display-server");
        } catch (const Error& error) {
            return error.what();
        }
        return "taken";
    };
    for (const char* text :
         {"", "localhost", "localhost:", "localhost:0", "localhost:65536", "localhost:-1",
          "localhost:+80", "localhost:99999999999", "localhost:tev", ":14158", "localhost:14158 "})
        EXPECT_NE(refusal(text).find("; write HOST:PORT, as 127.0.0.1:14158"), std::string::npos)
            << text << ": " << refusal(text);
    for (const char* text : {"::1:14158", "[]:14158", "[::1:14158", "::1]:14158"})
        EXPECT_NE(refusal(text).find("in brackets: [::1]:14158"), std::string::npos) << text;
}

}  // namespace
}  // namespace sunfleck::engine
