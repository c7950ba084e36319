// Words in messages: lists of known words, and suggestions for misspelled ones.
#pragma once

#include "core/printable.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Returns `use "a", "b" or "c"`, the remedy for an unknown word; a similar word comes first.
/// @param known  not empty.
std::string use_one_of(std::span<const std::string_view> known, std::string_view instead_of);

/// Returns the words of a table, in the order of its rows. @tparam Row  has a `word`.
template <class Row, std::size_t N>
constexpr std::array<std::string_view, N> words_of(const std::array<Row, N>& rows) {
    std::array<std::string_view, N> words;
    for (std::size_t i = 0; i < N; ++i) words[i] = rows[i].word;
    return words;
}

/// Returns `did you mean "Shape"?` if a known word is similar, else `check the spelling`.
std::string did_you_mean(std::span<const std::string_view> known, std::string_view instead_of);

/// Returns the keys of a map from names, for did_you_mean(); they refer to the map.
template <class Map>
std::vector<std::string_view> names_of(const Map& map) {
    std::vector<std::string_view> names;
    names.reserve(map.size());
    for (const auto& [name, value] : map) names.push_back(name);
    return names;
}

}  // namespace sunfleck::engine
