// Base64 (RFC 4648) and percent-encoding (RFC 3986).
#include "import/gltf/uri.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the value of a base64 digit, or -1.
int base64_value(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    if (c == '/' || c == '_') return 63;
    return -1;
}

int hex_value(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    unsigned held = 0;
    for (const char c : text) {
        const int value = base64_value(c);
        if (value < 0) return {};
        bits = bits << 6U | static_cast<std::uint32_t>(value);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> held & 0xFFU);
    }
    if (held >= 6) return {};  // a digit alone
    return bytes;
}

std::optional<DataUri> data_of(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (!is_data_uri(uri) || comma == std::string_view::npos) return {};
    const std::string_view head = uri.substr(5, comma - 5);
    constexpr std::string_view kBase64 = ";base64";
    if (!head.ends_with(kBase64)) return {};
    auto bytes = from_base64(uri.substr(comma + 1));
    if (!bytes) return {};
    return DataUri{std::string(head.substr(0, head.find(';'))), std::move(*bytes)};
}

std::string without_escapes(std::string_view uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool is_escape = uri[i] == '%' && i + 2 < uri.size() && hex_value(uri[i + 1]) >= 0 &&
                               hex_value(uri[i + 2]) >= 0;
        if (!is_escape) {
            name += uri[i];
            continue;
        }
        name += static_cast<char>(hex_value(uri[i + 1]) * 16 + hex_value(uri[i + 2]));
        i += 2;
    }
    return name;
}

std::vector<std::string> names_of_file(std::string_view uri) {
    std::vector<std::string> names = {without_escapes(uri)};
    if (names.front() != uri) names.emplace_back(uri);
    std::string turned = names.front();
    std::replace(turned.begin(), turned.end(), '\\', '/');
    if (turned != names.front()) names.push_back(std::move(turned));
    return names;
}

}  // namespace sunfleck::engine
