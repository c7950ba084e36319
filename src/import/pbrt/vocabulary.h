// The table of the language's words with their treatment, for `sunfleck info` and
// docs/reference/scenes.md.
#pragma once

#include "import/pbrt/vocabulary_row.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Returns the word for info and the documentation.
std::string_view name_of(Treatment treatment);

/// Returns all rows by directive, in the order of the documentation.
std::span<const WordRow> vocabulary();

/// Returns the row of a word, else that of any other word of the directive, else null.
const WordRow* find_word(std::string_view directive, std::string_view word);

/// Returns the rows of one directive as a Markdown table.
std::string vocabulary_table(std::string_view directive);

/// Returns the directives that have rows, in the order of the documentation.
std::vector<std::string_view> vocabulary_directives();

}  // namespace sunfleck::engine
