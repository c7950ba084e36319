// Tokens, their places, and what is no token.
#include "import/pbrt/lexer.h"

#include <gtest/gtest.h>

#include <vector>

namespace sunfleck {
namespace {

std::vector<std::string> words_of(const std::string& text) {
    Lexer lexer(text, "a.pbrt");
    std::vector<std::string> words;
    while (const auto token = lexer.next()) words.emplace_back(token->text);
    return words;
}

std::string error_in(const std::string& text) {
    try {
        words_of(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Lexer, cuts_words_strings_and_brackets) {
    const std::vector<std::string> expected = {"Shape", "sphere", "float radius", "[", "3",
                                               "]",     "[",      "1e-3",         "]", "x"};
    EXPECT_EQ(words_of("Shape\t\"sphere\"\r\n\"float radius\"[3][1e-3]x"), expected);
}

TEST(Lexer, comments_end_with_the_line_and_may_stand_anywhere) {
    const std::vector<std::string> expected = {"a", "b", "#c", "d"};
    EXPECT_EQ(words_of("a# \"open [\n#\nb \"#c\"#x\nd#"), expected);
}

TEST(Lexer, knows_kinds_and_places) {
    Lexer lexer("\n  Scale \"a b\" ]", "a.pbrt");
    const Token word = *lexer.next();
    EXPECT_EQ(word.kind, TokenKind::word);
    EXPECT_EQ(word.where().text(), "a.pbrt:2:3");
    const Token string = *lexer.next();
    EXPECT_EQ(string.kind, TokenKind::string);
    EXPECT_EQ(string.where().text(), "a.pbrt:2:9");
    const Token close = *lexer.next();
    EXPECT_EQ(close.kind, TokenKind::close);
    EXPECT_EQ(close.column, 15);
    EXPECT_FALSE(lexer.next());
}

TEST(Lexer, undoes_escapes) {
    Lexer lexer(R"("a\"b\\c\nd" "\q")", "a.pbrt");
    EXPECT_EQ(unescaped(*lexer.next()), "a\"b\\c\nd");
    const Token bad = *lexer.next();
    EXPECT_THROW(unescaped(bad), Error);
}

TEST(Lexer, a_string_ends_on_its_line) {
    EXPECT_EQ(error_in("x \"abc\ndef\""),
              "a.pbrt:1:3: a string has no closing quote on its line; close it with \"");
    EXPECT_NE(error_in("\"abc"), "");
    EXPECT_NE(error_in("\"abc\\"), "");
    EXPECT_NE(error_in("\"abc\\\""), "");
}

TEST(Lexer, refuses_tokens_beyond_all_measure) {
    EXPECT_EQ(words_of(std::string(65536, 'a')).size(), 1U);
    EXPECT_NE(error_in(std::string(65537, 'a')), "");
    EXPECT_NE(error_in('"' + std::string(65537, 'a') + '"'), "");
}

}  // namespace
}  // namespace sunfleck
