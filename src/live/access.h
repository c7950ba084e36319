// Who may ask a LiveServer: whoever knows the token, by a page that the server itself has sent.
#pragma once

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Returns 128 random bits of the system in hexadecimal digits.
/// @throws Error if the system has none.
std::string new_token();

/// Returns whether both are the same, in a time that does not tell where they differ.
bool is_token(std::string_view asked, std::string_view token);

/// Returns whether a Host header names this machine by itself, with any port: a browser that a name
/// of elsewhere has led here says that name.
/// @param bound  where the server listens beside loopback; empty: nowhere; 0.0.0.0 or :: : at all
/// addresses of the machine, which may be said as numbers or by the machine's name.
bool is_own_host(std::string_view host, const std::string& bound);

/// Returns an address as it stands in a URL: the machine's name for all of them.
std::string url_host(const std::string& bound);

/// Returns whether an Origin header, empty if there is none, is that of the host's own pages.
bool is_own_origin(std::string_view origin, std::string_view host);

}  // namespace sunfleck::engine
