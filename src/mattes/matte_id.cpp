// Names become UTF-8, hashes, floats.
#include "mattes/matte_id.h"

#include "mattes/murmur3.h"

#include <fmt/format.h>

#include <cstddef>

namespace sunfleck::engine {
namespace {

/// Returns how many bytes a character takes that begins with this one; 0 if none does.
std::size_t length_after(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return 2;
    if (first >= 0xE0 && first <= 0xEF) return 3;
    return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/// Returns the length of the character at the beginning of the text; 0 if there is none.
/// Source: The Unicode Standard 15.0, table 3-7.
std::size_t character_at(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = length_after(byte(0));
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
    if (byte(0) == 0xE0 && byte(1) < 0xA0) return 0;
    if (byte(0) == 0xED && byte(1) > 0x9F) return 0;
    if (byte(0) == 0xF0 && byte(1) < 0x90) return 0;
    if (byte(0) == 0xF4 && byte(1) > 0x8F) return 0;
    return length;
}

}  // namespace

MatteId matte_id(std::string_view name) {
    constexpr std::uint32_t kExponent = 0xFF;
    const std::uint32_t hash = murmur3_32(name);
    const std::uint32_t exponent = hash >> 23U & kExponent;
    return exponent == 0 || exponent == kExponent ? hash ^ 1U << 23U : hash;
}

std::string hex_of(MatteId id) {
    return fmt::format("{:08x}", id);
}

std::string as_utf8(std::string_view name) {
    std::string text;
    while (!name.empty()) {
        const std::size_t length = character_at(name);
        if (length == 0)
            text += "\xEF\xBF\xBD";
        else
            text += name.substr(0, length);
        name.remove_prefix(length == 0 ? 1 : length);
    }
    return text;
}

}  // namespace sunfleck::engine
