// Text without the difference between capital and small letters.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace sunfleck::engine {

/// @param text  ASCII; other bytes stay.
inline std::string small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace sunfleck::engine
