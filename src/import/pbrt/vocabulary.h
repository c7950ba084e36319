// What each word of the language means to us: the table behind `sunfleck info` and docs/scenes.md.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck {

enum class Treatment {
    exact,         // as pbrt-v4 means it
    approximated,  // something else stands in for it; a warning says so
    ignored,       // read, and without effect; a warning says so where the picture would differ
    refused        // an error
};

/// As info and the documentation say it.
std::string_view name_of(Treatment treatment);

struct WordRow {
    std::string_view directive;  // "Shape"
    std::string_view word;       // "plymesh"; of "Directive" itself, several with blanks between
    Treatment treatment = Treatment::exact;
    std::string_view read_as;  // Markdown, within a table's cell
};

/// All of them, by directive, in the order of the documentation.
std::span<const WordRow> vocabulary();

/// The row of a word, else that of any other word of the directive, else null.
const WordRow* find_word(std::string_view directive, std::string_view word);

/// The rows of one directive as a Markdown table.
std::string vocabulary_table(std::string_view directive);

/// The directives that have rows, in the order of the documentation.
std::vector<std::string_view> vocabulary_directives();

}  // namespace sunfleck
