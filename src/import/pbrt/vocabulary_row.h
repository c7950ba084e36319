// One word of the language, and what it means to us.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck::engine {

enum class Treatment {
    exact,         // as pbrt-v4 means it
    approximated,  // something else stands in for it; a warning says so
    ignored,       // read, and without effect; a warning says so where the picture would differ
    refused        // an error
};

inline constexpr auto kExact = Treatment::exact;
inline constexpr auto kApproximated = Treatment::approximated;
inline constexpr auto kIgnored = Treatment::ignored;
inline constexpr auto kRefused = Treatment::refused;

struct WordRow {
    std::string_view directive;  // "Shape"
    std::string_view word;       // "plymesh"; of "Directive" itself, several with blanks between
    Treatment treatment = Treatment::exact;
    std::string_view read_as;  // Markdown, within a table's cell
};

/// The rows of a directive whose words are read by a table of their own.
/// @param rows  each with `word`, `treatment` and `read_as`.
template <class Row, std::size_t N>
constexpr std::array<WordRow, N> word_rows(std::string_view directive,
                                           const std::array<Row, N>& rows) {
    std::array<WordRow, N> words;
    for (std::size_t i = 0; i < N; ++i)
        words[i] = {directive, rows[i].word, rows[i].treatment, rows[i].read_as};
    return words;
}

}  // namespace sunfleck::engine
