// One word of the language, and what it means to us.
#pragma once

#include <string_view>

namespace sunfleck::engine {

enum class Treatment {
    exact,         // as pbrt-v4 means it
    approximated,  // something else stands in for it; a warning says so
    ignored,       // read, and without effect; a warning says so where the picture would differ
    refused        // an error
};

struct WordRow {
    std::string_view directive;  // "Shape"
    std::string_view word;       // "plymesh"; of "Directive" itself, several with blanks between
    Treatment treatment = Treatment::exact;
    std::string_view read_as;  // Markdown, within a table's cell
};

}  // namespace sunfleck::engine
