// One word of the language, and its treatment.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck::engine {

enum class Treatment {
    exact,         // with the meaning of pbrt-v4
    approximated,  // replaced by something similar; a warning says so
    ignored,       // read without effect; a warning says so where the picture would differ
    refused,       // an error
    ours           // a word that pbrt-v4 refuses
};

inline constexpr auto kExact = Treatment::exact;
inline constexpr auto kApproximated = Treatment::approximated;
inline constexpr auto kIgnored = Treatment::ignored;
inline constexpr auto kRefused = Treatment::refused;
inline constexpr auto kOurs = Treatment::ours;

struct WordRow {
    std::string_view directive;  // "Shape"
    std::string_view word;       // "plymesh"; for "Directive", several separated by blanks
    Treatment treatment = Treatment::exact;
    std::string_view read_as;  // Markdown, for a table cell
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
