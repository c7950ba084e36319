// Words in messages: similarity by edit distance.
#include "import/pbrt/words.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kLongestSimilar = 60;

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Insertions, deletions and replacements that turn a into b, capitals aside (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

/// The word at most a third of its letters away, or nothing.
std::string_view nearest(std::span<const std::string_view> known, std::string_view word) {
    if (word.size() > kLongestSimilar) return {};
    std::string_view best;
    std::size_t least = word.size() / 3 + 1;
    for (const std::string_view candidate : known) {
        const std::size_t distance = edit_distance(candidate, word);
        if (distance >= least) continue;
        least = distance;
        best = candidate;
    }
    return best;
}

}  // namespace

std::string use_one_of(std::span<const std::string_view> known, std::string_view instead_of) {
    std::vector<std::string_view> words(known.begin(), known.end());
    std::erase(words, std::string_view());
    const auto best = std::find(words.begin(), words.end(), nearest(known, instead_of));
    if (best != words.end()) std::rotate(words.begin(), best, best + 1);
    std::string text = "use ";
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text += in_quotes(words[i]);
    }
    return text;
}

std::string did_you_mean(std::span<const std::string_view> known, std::string_view instead_of) {
    const std::string_view best = nearest(known, instead_of);
    if (best.empty()) return "check the spelling";
    return "did you mean " + in_quotes(best) + "?";
}

}  // namespace sunfleck::engine
