// The address of a display server, as pbrt-v4 has it: HOST:PORT.
#pragma once

#include <string>

namespace sunfleck::engine {

struct DisplayAddress {
    std::string host;  // a name, or a number of IPv4 or IPv6; without brackets
    std::string port;  // a number from 1 to 65535
    std::string text;  // as the user has written it
};

/// Returns the parts of HOST:PORT; an IPv6 host stands in brackets: [::1]:14158.
/// @param flag  what the text was given to.
/// @throws Error for any other text.
DisplayAddress read_display_address(const std::string& text, const std::string& flag);

}  // namespace sunfleck::engine
