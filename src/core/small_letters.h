// Lower case, for comparison of text without regard to capitals.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace sunfleck::engine {

/// Returns the text in lower case. @param text  ASCII letters change; other bytes stay.
inline std::string small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace sunfleck::engine
