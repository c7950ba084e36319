// One word of the language, and its treatment.
#pragma once

#include <string_view>

namespace sunfleck::engine {

enum class Treatment {
    exact,         // with the meaning of pbrt-v4
    approximated,  // replaced by something similar; a warning says so
    ignored,       // read without effect; a warning says so where the picture would differ
    refused        // an error
};

struct WordRow {
    std::string_view directive;  // "Shape"
    std::string_view word;       // "plymesh"; for "Directive", several separated by blanks
    Treatment treatment = Treatment::exact;
    std::string_view read_as;  // Markdown, for a table cell
};

}  // namespace sunfleck::engine
