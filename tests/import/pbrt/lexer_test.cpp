// Tokens, their places, and what is no token.
#include "import/pbrt/lexer.h"

#include <gtest/gtest.h>

#include <vector>

namespace sunfleck::engine {
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
    Lexer lexer(R"("a\"b\\c\nd" "\q" "tex\wall.png")", "a.pbrt");
    EXPECT_EQ(unescaped(*lexer.next()), "a\"b\\c\nd");
    EXPECT_EQ(unescaped(*lexer.next()), "\\q");
    EXPECT_EQ(unescaped(*lexer.next()), "tex\\wall.png");
}

TEST(Lexer, passes_over_a_byte_order_mark) {
    Lexer lexer("\xEF\xBB\xBFScale 1", "a.pbrt");
    EXPECT_EQ(lexer.next()->where().text(), "a.pbrt:1:1");
    EXPECT_EQ(lexer.next()->where().text(), "a.pbrt:1:7");
    EXPECT_TRUE(words_of("\xEF\xBB\xBF").empty());
}

TEST(Lexer, lines_may_end_as_on_any_system) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        Lexer lexer(std::string("a # b") + end + end + "c", "a.pbrt");
        EXPECT_EQ(lexer.next()->text, "a");
        EXPECT_EQ(lexer.next()->where().text(), "a.pbrt:3:1");
    }
}

TEST(Lexer, names_characters_that_look_like_others) {
    EXPECT_EQ(error_in("Scale\xC2\xA0"
                       "1 1 1"),
              "a.pbrt:1:6: U+00A0 (no-break space) stands here, which no word has; write a plain "
              "space");
    const std::vector<std::pair<std::string, std::string>> odd = {
        {"\xE2\x80\x89", "U+2009 (typographic space)"},
        {"\xE3\x80\x80", "U+3000 (ideographic space)"},
        {"\xE2\x80\x8B", "U+200B (invisible character)"},
        {"\xE2\x80\x9C", "U+201C (quotation mark)"},
        {"\xE2\x88\x92", "U+2212 (minus sign)"},
        {"\xEF\xBB\xBF", "U+FEFF (byte order mark within the text)"},
        {"\xC2\x85", "U+0085 (next line)"},
        {"\xA0", "byte A0, which is no UTF-8"},
        {"\xE2\x80", "byte E2, which is no UTF-8"},
        {"\xC3\xA9", "U+00E9"},
        {"\x0C", "U+000C"},
        {"\x1A", "U+001A (end-of-file mark of DOS)"},
        {std::string(1, '\0'), "U+0000 (a zero byte)"}};
    for (const auto& [bytes, name] : odd)
        EXPECT_NE(error_in("Scale\n1 2" + bytes + "3 ").find("a.pbrt:2:4: " + name),
                  std::string::npos)
            << name << ": " << error_in("Scale\n1 2" + bytes + "3 ");
    EXPECT_EQ(error_in("\"\xC2\xA0\" # \xC2\xA0"), "");
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
}  // namespace sunfleck::engine
