// Words in messages: always one printable line, and the right suggestion.
#include "import/pbrt/words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

namespace sunfleck::engine {
namespace {

constexpr std::array<std::string_view, 4> kKnown = {"Shape", "Scale", "", "Material"};

TEST(Words, are_quoted_on_one_line) {
    EXPECT_EQ(in_quotes("a\nb\x01"), "\"a?b?\"");
    EXPECT_EQ(in_quotes(std::string(100, 'x')), fmt::format("\"{}...\"", std::string(60, 'x')));
}

TEST(Words, suggest_the_nearest) {
    EXPECT_EQ(did_you_mean(kKnown, "shpae"), "check the spelling");
    EXPECT_EQ(did_you_mean(kKnown, "Shap"), "did you mean \"Shape\"?");
    EXPECT_EQ(did_you_mean(kKnown, "material"), "did you mean \"Material\"?");
    EXPECT_EQ(use_one_of(kKnown, "Materal"), "use \"Material\", \"Shape\" or \"Scale\"");
    EXPECT_EQ(use_one_of(kKnown, "zzz"), "use \"Shape\", \"Scale\" or \"Material\"");
}

}  // namespace
}  // namespace sunfleck::engine
