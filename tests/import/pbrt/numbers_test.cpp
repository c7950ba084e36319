// Numbers: every form that is one, and what is none.
#include "import/pbrt/numbers.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Token word(std::string_view text) {
    static const std::string file = "a.pbrt";
    return {TokenKind::word, text, &file, 1, 1};
}

TEST(Numbers, reads_all_forms) {
    EXPECT_EQ(real_of(word("1")), 1);
    EXPECT_EQ(real_of(word("-.5")), -0.5);
    EXPECT_EQ(real_of(word("+2.")), 2);
    EXPECT_EQ(real_of(word("1.5E+3")), 1500);
    EXPECT_EQ(real_of(word("0.1")), 0.1);
    EXPECT_EQ(real_of(word("1e-400")), 0);
    EXPECT_EQ(integer_of(word("-2147483648")), -2147483648);
    EXPECT_EQ(integer_of(word("+7")), 7);
}

TEST(Numbers, refuses_the_rest) {
    for (const char* text : {"", "x", "1x", "nan", "inf", "-infinity", "1e39", "1e999", "+-1",
                             "++1", "1,5", "0x10", "."})
        EXPECT_THROW(real_of(word(text)), Error) << text;
    for (const char* text : {"", "1.0", "1e3", "2147483648", "one", "true"})
        EXPECT_THROW(integer_of(word(text)), Error) << text;
}

TEST(Numbers, in_quotes_are_told_to_have_none) {
    Token token = word("1");
    token.kind = TokenKind::string;
    const auto message = [&](const auto& read) -> std::string {
        try {
            read(token);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(message(real_of).find("without quotes"), std::string::npos);
    EXPECT_NE(message(integer_of).find("without quotes"), std::string::npos);
}

TEST(Numbers, with_a_comma_are_told_to_have_a_point) {
    for (const char* text : {"0,5", ".5,", "400;0.5"}) {
        std::string message;
        try {
            real_of(word(text));
        } catch (const Error& error) {
            message = error.what();
        }
        EXPECT_NE(message.find("with a point"), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace sunfleck::engine
