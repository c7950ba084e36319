// What each word of the language means to us: the table behind `sunfleck info` and
// docs/reference/scenes.md.
#pragma once

#include "import/pbrt/vocabulary_row.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// As info and the documentation say it.
std::string_view name_of(Treatment treatment);

/// All of them, by directive, in the order of the documentation.
std::span<const WordRow> vocabulary();

/// The row of a word, else that of any other word of the directive, else null.
const WordRow* find_word(std::string_view directive, std::string_view word);

/// The rows of one directive as a Markdown table.
std::string vocabulary_table(std::string_view directive);

/// The directives that have rows, in the order of the documentation.
std::vector<std::string_view> vocabulary_directives();

}  // namespace sunfleck::engine
