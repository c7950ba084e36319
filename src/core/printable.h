// Text of unknown origin, for messages of one line.
#pragma once

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// The text, its control characters replaced by '?', and "..." for what is beyond `most` bytes.
inline std::string printable(std::string_view text, std::size_t most) {
    std::string shown(text.substr(0, most));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return text.size() > most ? shown + "..." : shown;
}

/// The same in quotes.
inline std::string in_quotes(std::string_view text, std::size_t most = 60) {
    return '"' + printable(text, most) + '"';
}

}  // namespace sunfleck::engine
