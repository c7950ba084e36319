// Suggestions by edit distance.
#include "import/pbrt/words.h"

#include "core/edit_distance.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kLongestSimilar = 60;

/// Returns the nearest word within a third of its letters, or nothing.
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
