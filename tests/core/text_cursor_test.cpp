// Words, numbers and places of a text.
#include "core/text_cursor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(TextCursor, reads_words_line_by_line_whatever_ends_lines) {
    const std::string name = "a.obj";
    TextCursor cursor("v  1\t2 # no word\r\nname with # blanks  \rlast", name);
    EXPECT_EQ(cursor.word(), "v");
    EXPECT_EQ(cursor.number("x"), 1);
    EXPECT_EQ(cursor.word(), "2");
    EXPECT_EQ(cursor.word(), "");
    EXPECT_TRUE(cursor.at_line_end());
    cursor.next_line();
    EXPECT_EQ(cursor.rest_of_line(), "name with # blanks");
    cursor.next_line();
    EXPECT_EQ(cursor.location().text(), "a.obj:3:1");
    EXPECT_EQ(cursor.word_of_text(), "last");
    EXPECT_EQ(cursor.word_of_text(), "");
    EXPECT_TRUE(cursor.at_end());
}

/// Also where the backslash touches the word before it.
TEST(TextCursor, continues_a_line_behind_a_backslash) {
    const std::string name = "a";
    TextCursor cursor("f 1 \\\r\n 2\\\n3 \\x\\y\n4", name);
    std::string words;
    for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word())
        words += std::string(word) + ".";
    EXPECT_EQ(words, "f.1.2.3.\\x\\y.");
}

TEST(TextCursor, reads_numbers_as_writers_of_all_systems_write_them) {
    EXPECT_EQ(number_of("+1.5"), 1.5);
    EXPECT_EQ(number_of("-2e3"), -2000);
    EXPECT_EQ(number_of("1e-999"), 0);
    EXPECT_EQ(number_of("-1e999"), -HUGE_VAL);
    EXPECT_EQ(number_of("-1.#INF"), -HUGE_VAL);
    EXPECT_TRUE(std::isnan(number_of("1.#QNAN").value()));
    EXPECT_TRUE(std::isnan(number_of("-nan").value()));
    for (const char* word : {"", "+", "+-1", "1,5", "1.5x", "a", "1.#X"})
        EXPECT_FALSE(number_of(word)) << word;
}

TEST(TextCursor, says_where_a_number_is_wrong) {
    const std::string name = "a.mtl";
    const auto fault = [&](const std::string& text) {
        try {
            TextCursor cursor(text, name);
            cursor.next_line();
            cursor.word();
            cursor.number("a number");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(fault("\nNs 1,5"),
              "a.mtl:2:4: \"1,5\" is no number; write a point in place of the comma");
    EXPECT_EQ(fault("\r\nNs x"), "a.mtl:2:4: \"x\" is no number; give a number");
    EXPECT_EQ(fault("\rNs "),
              "a.mtl:2:4: the line ends where a number is expected; give all "
              "numbers of the statement");
    EXPECT_EQ(fault("\nNs 3"), "");
}

TEST(TextCursor, finds_numbers_that_may_be_there) {
    const std::string name = "a";
    TextCursor cursor("1 2 file 3", name);
    EXPECT_EQ(cursor.find_number(), 1);
    EXPECT_EQ(cursor.find_number(), 2);
    EXPECT_EQ(cursor.find_number(), std::nullopt);
    EXPECT_EQ(cursor.word(), "file");
}

}  // namespace
}  // namespace sunfleck::engine
