// Words of a scene file in messages, and the known word that an unknown one may mean.
#pragma once

#include "core/printable.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// `use "a", "b" or "c"`: the remedy for an unknown word, the most similar one first where one is
/// close. @param known  not empty.
std::string use_one_of(std::span<const std::string_view> known, std::string_view instead_of);

/// The words of a table, in the order of its rows. @tparam Row  has a `word`.
template <class Row, std::size_t N>
constexpr std::array<std::string_view, N> words_of(const std::array<Row, N>& rows) {
    std::array<std::string_view, N> words;
    for (std::size_t i = 0; i < N; ++i) words[i] = rows[i].word;
    return words;
}

/// `did you mean "Shape"?` where a known word is close, or `check the spelling`.
std::string did_you_mean(std::span<const std::string_view> known, std::string_view instead_of);

}  // namespace sunfleck::engine
