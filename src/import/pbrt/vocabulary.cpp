// Lookup of words, and the table as Markdown.
#include "import/pbrt/vocabulary.h"

#include "import/pbrt/camera.h"
#include "import/pbrt/data_vocabulary.h"
#include "import/pbrt/film.h"
#include "import/pbrt/lights.h"
#include "import/pbrt/materials.h"
#include "import/pbrt/shapes.h"
#include "import/pbrt/texture_kinds.h"

#include <fmt/format.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns whether `word` is one of the blank-separated words of a row.
bool names(const WordRow& row, std::string_view word) {
    if (row.word == word) return true;
    for (std::size_t at = row.word.find(word); at != std::string_view::npos && !word.empty();
         at = row.word.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || row.word[at - 1] == ' ';
        if (begins && (end == row.word.size() || row.word[end] == ' ')) return true;
    }
    return false;
}

}  // namespace

std::string_view name_of(Treatment treatment) {
    switch (treatment) {
        case Treatment::exact:
            return "exact";
        case Treatment::approximated:
            return "approximated";
        case Treatment::ignored:
            return "ignored";
        case Treatment::refused:
            return "refused";
        case Treatment::ours:
            return "ours";
    }
    return "";
}

std::span<const WordRow> vocabulary() {
    static const std::vector<WordRow> all_rows = [] {
        std::vector<WordRow> all;
        for (const std::span<const WordRow> words :
             {std::span<const WordRow>(kDirectiveWords), camera_words(),
              std::span<const WordRow>(kFilmWords), filter_words(),
              std::span<const WordRow>(kMethodWords), shape_words(), material_words(),
              texture_words(), light_words(), std::span<const WordRow>(kAreaLightWords),
              std::span<const WordRow>(kMediumWords)})
            all.insert(all.end(), words.begin(), words.end());
        return all;
    }();
    return all_rows;
}

const WordRow* find_word(std::string_view directive, std::string_view word) {
    const WordRow* any = nullptr;
    for (const WordRow& row : vocabulary()) {
        if (row.directive != directive) continue;
        if (names(row, word)) return &row;
        if (row.word.starts_with("any")) any = &row;
    }
    return any;
}

std::string vocabulary_table(std::string_view directive) {
    std::string text = fmt::format("| {} | | Read as |\n|---|---|---|\n", directive);
    for (const WordRow& row : vocabulary()) {
        if (row.directive != directive) continue;
        const bool is_plain = row.word.starts_with("any");
        const std::string word = is_plain           ? std::string(row.word)
                                 : row.word.empty() ? "`\"\"`"
                                                    : fmt::format("`{}`", row.word);
        text += fmt::format("| {} | {} | {} |\n", word, name_of(row.treatment), row.read_as);
    }
    return text;
}

std::vector<std::string_view> vocabulary_directives() {
    std::vector<std::string_view> all;
    for (const WordRow& row : vocabulary())
        if (all.empty() || all.back() != row.directive) all.push_back(row.directive);
    return all;
}

}  // namespace sunfleck::engine
