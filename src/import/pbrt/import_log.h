// ImportLog: the warnings of an import, and counts of the words that the scene uses.
#pragma once

#include "core/warnings.h"
#include "import/pbrt/parameters.h"
#include "scene/description.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunfleck::engine {

class ImportLog {
public:
    /// Adds a warning; beyond some hundred different ones it only tells that there are more.
    void warn(const SourceLocation& where, const std::string& text);
    /// Warns of parameters that no lookup used.
    void warn_unused(const Statement& statement);
    /// Counts a word that the scene uses, such as `sphere` of the directive `Shape`.
    void count_word(std::string_view directive, std::string_view word);

    /// Adds all warnings and words of another log.
    void append(const ImportLog& other);

    const Warnings& warnings() const { return warnings_; }
    /// Returns the counted words, sorted by directive and word.
    std::vector<UsedWord> words() const;

private:
    Warnings warnings_;
    std::map<std::pair<std::string, std::string>, std::size_t> words_;  // by directive and word
};

}  // namespace sunfleck::engine
