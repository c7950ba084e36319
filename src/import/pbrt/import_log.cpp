// Counts of words, and the limit of warnings.
#include "import/pbrt/import_log.h"

namespace sunfleck::engine {

void ImportLog::warn(const SourceLocation& where, const std::string& text) {
    constexpr std::size_t kMostWarnings = 500;
    const bool full = warnings_.entries().size() >= kMostWarnings;
    warnings_.add(where, full ? "further warnings are not listed" : text);
}

void ImportLog::warn_unused(const Statement& statement) {
    for (const Parameter* parameter : statement.unused())
        warn(parameter->where,
             "unused parameter " + parameter->title() + " of " + statement.title() + " is ignored");
}

void ImportLog::count_word(std::string_view directive, std::string_view word) {
    ++words_[{std::string(directive), std::string(word)}];
}

void ImportLog::append(const ImportLog& other) {
    for (const Warnings::Entry& entry : other.warnings_.entries())
        for (int i = 0; i < entry.count; ++i) warn(entry.where, entry.text);
    for (const auto& [word, count] : other.words_) words_[word] += count;
}

std::vector<UsedWord> ImportLog::words() const {
    std::vector<UsedWord> all;
    for (const auto& [word, count] : words_) all.push_back({word.first, word.second, count});
    return all;
}

}  // namespace sunfleck::engine
