// Host and port are parted at the last colon.
#include "display/address.h"

#include "sunfleck/error.h"

#include <algorithm>
#include <charconv>

namespace sunfleck::engine {
namespace {

constexpr int kMostPort = 65535;

bool is_port(const std::string& text) {
    const bool is_number = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return c >= '0' && c <= '9';
    });
    int port = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), port);
    return is_number && read.ec == std::errc() && port >= 1 && port <= kMostPort;
}

}  // namespace

DisplayAddress read_display_address(const std::string& text, const std::string& flag) {
    const auto refuse = [&](const std::string& what, const std::string& mend) {
        throw Error({flag}, what, mend);
    };
    const std::string form = "write HOST:PORT, as 127.0.0.1:14158, where tev listens";
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) refuse("\"" + text + "\" has no port", form);
    DisplayAddress address{text.substr(0, colon), text.substr(colon + 1), text};
    if (!is_port(address.port))
        refuse("\"" + address.port + "\" is no port from 1 to " + std::to_string(kMostPort), form);
    std::string& host = address.host;
    if (host.size() > 2 && host.starts_with('[') && host.ends_with(']'))
        host = host.substr(1, host.size() - 2);
    else if (host.find_first_of(":[]") != std::string::npos)
        refuse("\"" + text + "\" has colons or brackets in its host",
               "write IPv6 in brackets: [::1]:14158");
    if (host.empty()) refuse("\"" + text + "\" has no host", form);
    return address;
}

}  // namespace sunfleck::engine
