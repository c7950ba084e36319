// What an import tells of its scene: the warnings, and how often each word of the language is used.
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
    /// Adds a warning; after some hundred different ones only that there are more.
    void warn(const SourceLocation& where, const std::string& text);
    /// Warns of parameters that nobody asked for.
    void warn_unused(const Statement& statement);
    /// Counts a word that the scene uses: of the directive `Shape`, `sphere`.
    void count_word(std::string_view directive, std::string_view word);

    const Warnings& warnings() const { return warnings_; }
    /// All words that were counted, sorted by directive and word.
    std::vector<UsedWord> words() const;

private:
    Warnings warnings_;
    std::map<std::pair<std::string, std::string>, std::size_t> words_;  // by directive and word
};

}  // namespace sunfleck::engine
