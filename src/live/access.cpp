// Tokens by getrandom(2); names of the loopback interface.
#include "live/access.h"

#include "sunfleck/error.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace sunfleck::engine {

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

bool is_own_host(std::string_view host) {
    const std::size_t colon = host.rfind(':');
    const bool has_port = colon != std::string_view::npos && colon + 1 < host.size() &&
                          host.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
    const std::string_view name = has_port ? host.substr(0, colon) : host;
    return name == "127.0.0.1" || name == "localhost" || name == "[::1]";
}

bool is_own_origin(std::string_view origin, std::string_view host) {
    return origin.empty() || origin == "http://" + std::string(host);
}

}  // namespace sunfleck::engine
