// Lower case, for comparison of text without regard to capitals.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace sunfleck::engine {

/// Returns the text in lower case. @param text  ASCII letters change; other bytes stay.
inline std::string small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Returns the ending of a file's name in lower case, with its dot: ".exr"; empty for none.
inline std::string small_ending(const std::string& path) {
    return small_letters(std::filesystem::path(path).extension().string());
}

}  // namespace sunfleck::engine
