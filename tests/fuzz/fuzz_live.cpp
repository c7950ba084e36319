// Fuzz target: any bytes that a peer sends to a live page's server leave it answering. The word
// TOKEN stands for its token, so that requests reach what is behind it.
#include "live/http.h"
#include "live/server.h"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

using namespace sunfleck::engine;  // NOLINT(google-build-using-namespace): a program of its own

/// A server of a render of one pixel, which lives as long as the program.
struct Served {
    std::shared_ptr<LiveBoard> board = std::make_shared<LiveBoard>();
    std::shared_ptr<LiveWishes> wishes = std::make_shared<LiveWishes>();
    LiveServer server{board, wishes, "", [] {}};
    testing_support::Address address{server.url()};

    Served() {
        Picture picture{1, 1, {}, {{"light_groups", "lamp"}}};
        for (const char* name : {"R", "G", "B", "lamp.R", "lamp.G", "lamp.B"}) picture.add(name);
        board->show(std::move(picture));
        board->tell("{}");
        wishes->accept();
    }
};

std::string with_token(std::string bytes, const std::string& token) {
    const std::string mark = "TOKEN";
    for (auto at = bytes.find(mark); at != bytes.npos; at = bytes.find(mark, at + token.size()))
        bytes.replace(at, mark.size(), token);
    return bytes;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Served& served = *new Served;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    const auto& [port, token] = served.address;
    {
        const testing_support::Connection peer(port);
        peer.send(with_token(bytes, token));
        peer.send("\r\n\r\n");
        peer.finish();
        peer.receive();
    }
    served.wishes->take_look();
    const std::string page =
        testing_support::ask(port, testing_support::request("GET", "/picture?token=" + token));
    if (testing_support::status_of(page) != 200) std::abort();
    return 0;
}
