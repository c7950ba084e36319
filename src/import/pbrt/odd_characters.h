// Characters that look like a space, a quote or a minus, and are none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// A character that no word of the language has.
struct OddCharacter {
    std::size_t at = 0;  // bytes before it
    std::string what;    // U+00A0 (no-break space)
    std::string mend;    // write a plain space
};

/// May a word of the language hold this byte?
constexpr bool is_plain(char c) {
    return c > 0x20 && c < 0x7F;
}

/// The first character that is neither printable ASCII nor a space or tab, or nothing.
std::optional<OddCharacter> odd_character_in(std::string_view text);

}  // namespace sunfleck::engine
