// Former names of flags, so that a message can name the present one.
#pragma once

#include <array>
#include <string_view>

namespace sunfleck::engine {

struct RenamedFlag {
    std::string_view before;
    std::string_view now;
};

inline constexpr std::array<RenamedFlag, 8> kRenamedFlags = {{
    {"--emission-maps", "--emission-guide"},
    {"--ladder", "--splitting"},
    {"--layers", "--aovs"},
    {"--light-candidates", "--ris"},
    {"--light-groups", "--light-strata"},
    {"--light-layer", "--light-group"},
    {"--light-search", "--guide-search"},
    {"--noisy-pixels", "--adaptive-pixels"},
}};

/// @param word  of the command line: a flag, or a flag and its value after "=".
/// @return what the flag is called now; empty if no flag was called so.
constexpr std::string_view name_now(std::string_view word) {
    const std::string_view flag = word.substr(0, word.find('='));
    for (const RenamedFlag& row : kRenamedFlags)
        if (row.before == flag) return row.now;
    return {};
}

}  // namespace sunfleck::engine
