// Tokens by getrandom(2); names and addresses of this machine.
#include "live/access.h"

#include "sunfleck/error.h"

#include <arpa/inet.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace sunfleck::engine {
namespace {

bool is_every_address(const std::string& bound) {
    return bound == "0.0.0.0" || bound == "::";
}

/// Returns whether a host of a URL is an address, 192.0.2.1 or [2001:db8::1], and no name.
bool is_number(const std::string& host) {
    ::in6_addr address{};
    if (host.front() != '[') return ::inet_pton(AF_INET, host.c_str(), &address) == 1;
    return host.back() == ']' &&
           ::inet_pton(AF_INET6, host.substr(1, host.size() - 2).c_str(), &address) == 1;
}

std::string name_of_machine() {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return "localhost";
    return name.data();
}

}  // namespace

std::string new_token() {
    std::array<std::uint8_t, 16> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<::ssize_t>(bytes.size()))
        throw Error({"--view"}, "the system has no random numbers", "render without it",
                    ErrorCode::machine);
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string token;
    for (const std::uint8_t byte : bytes) {
        token += kDigits[byte >> 4U];
        token += kDigits[byte & 15U];
    }
    return token;
}

bool is_token(std::string_view asked, std::string_view token) {
    unsigned differing = asked.size() == token.size() ? 0U : 1U;
    for (std::size_t i = 0; i < std::min(asked.size(), token.size()); ++i)
        differing |= static_cast<unsigned char>(asked[i]) ^ static_cast<unsigned char>(token[i]);
    return differing == 0;
}

bool is_own_host(std::string_view host, const std::string& bound) {
    const std::size_t colon = host.rfind(':');
    const bool has_port = colon != std::string_view::npos && colon + 1 < host.size() &&
                          host.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
    const std::string name(has_port ? host.substr(0, colon) : host);
    if (name == "127.0.0.1" || name == "localhost" || name == "[::1]") return true;
    if (bound.empty() || name.empty()) return false;
    if (name == url_host(bound)) return true;
    return is_every_address(bound) && is_number(name);
}

std::string url_host(const std::string& bound) {
    if (bound.empty()) return "127.0.0.1";
    if (is_every_address(bound)) return name_of_machine();
    return bound.find(':') == std::string::npos ? bound : '[' + bound + ']';
}

bool is_own_origin(std::string_view origin, std::string_view host) {
    return origin.empty() || origin == "http://" + std::string(host);
}

}  // namespace sunfleck::engine
