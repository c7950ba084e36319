// Detection of characters that look like a space, quote or minus but are others.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// A character that no word of the language may have.
struct OddCharacter {
    std::size_t at = 0;  // bytes before it
    std::string what;    // U+00A0 (no-break space)
    std::string mend;    // write a plain space
};

/// Returns whether a word of the language may contain this byte.
constexpr bool is_plain(char c) {
    return c > 0x20 && c < 0x7F;
}

/// Returns the first character that is neither printable ASCII nor space or tab, or nothing.
std::optional<OddCharacter> odd_character_in(std::string_view text);

}  // namespace sunfleck::engine
