// Parameters: lists, types, counts, defaults, and what nobody asks for.
#include "import/pbrt/parameters.h"

#include "import/pbrt/parameter_parser.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Statement parsed(const std::string& text) {
    TokenStream tokens;
    tokens.push(text, "a.pbrt", {"a.pbrt"});
    const Token keyword = tokens.require("a keyword");
    return read_statement(tokens, keyword);
}

std::string error_in(const std::string& text) {
    try {
        parsed(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Parameters, are_read_with_and_without_brackets) {
    const Statement s = parsed(
        "Shape \"x\" \"float a\" 3 \"float b\" [4] \"bool c\" true \"bool d\" [ \"false\" ] "
        "\"point3 p\" [1 2 # comment ]\n 3] \"string s\" \"t u\" \"  integer   i \" [ -5 ]");
    EXPECT_EQ(s.real("a", 0), 3);
    EXPECT_EQ(s.real("b", 0), 4);
    EXPECT_TRUE(s.flag("c", false));
    EXPECT_FALSE(s.flag("d", true));
    EXPECT_EQ(s.point("p", {0, 0, 0}), Vec3d(1, 2, 3));
    EXPECT_EQ(s.text("s"), "t u");
    EXPECT_EQ(s.integer("i"), -5);
    EXPECT_TRUE(s.unused().empty());
}

TEST(Parameters, that_nobody_asks_for_are_listed) {
    const Statement s = parsed("Shape \"x\" \"float a\" 3\n \"float b\" 4");
    EXPECT_EQ(s.real("a", 0), 3);
    EXPECT_EQ(s.real("z", 9), 9);
    ASSERT_EQ(s.unused().size(), 1U);
    EXPECT_EQ(s.unused()[0]->title(), "\"float b\"");
    EXPECT_EQ(s.unused()[0]->where.text(), "a.pbrt:2:2");
}

TEST(Parameters, the_last_of_a_name_counts_and_own_ones_before_defaults) {
    Statement s = parsed("Shape \"x\" \"float a\" 1 \"float a\" 2");
    s.defaults = std::make_shared<const Parameters>(
        parsed("Attribute \"shape\" \"float a\" 3 \"float b\" 4 \"float b\" 5").own);
    EXPECT_EQ(s.real("a", 0), 2);
    EXPECT_EQ(s.real("b", 0), 5);
}

TEST(Parameters, of_the_wrong_type_or_count_are_errors) {
    EXPECT_THROW(parsed("S \"x\" \"integer a\" 1").real("a", 0), Error);
    EXPECT_THROW(parsed("S \"x\" \"float a\" [1 2]").real("a", 0), Error);
    EXPECT_THROW(parsed("S \"x\" \"float a\" []").real("a", 0), Error);
    EXPECT_THROW(parsed("S \"x\" \"point3 a\" [1 2 3 4 5 6]").point("a", {0, 0, 0}), Error);
    EXPECT_THROW(parsed("S \"x\" \"float a\" [1 2]").reals("a", 3), Error);
}

TEST(Parameters, lists_that_are_broken_are_errors) {
    EXPECT_EQ(error_in("S \"x\" \"float a\""),
              "a.pbrt:1:16: the file ends where a value of \"float a\" should follow; complete it, "
              "or check that it was copied whole");
    EXPECT_NE(error_in("S \"x\" \"float a\" [ 1"), "");
    EXPECT_NE(error_in("S \"x\" \"float a\" ]"), "");
    EXPECT_NE(error_in("S \"x\" \"float a\" [ 1 [ 2 ] ]"), "");
    EXPECT_NE(error_in("S \"x\" \"float a\" \"1\""), "");
    EXPECT_NE(error_in("S \"x\" \"string a\" b"), "");
    EXPECT_NE(error_in("S \"x\" \"bool a\" 1"), "");
    EXPECT_NE(error_in("S \"x\" \"radius\" 1"), "");
    EXPECT_NE(error_in("S \"x\" \"point3 P\" [1 2]"), "");
    EXPECT_NE(error_in("S \"x\" \"color c\" [1 1 1]").find("pbrt-v3"), std::string::npos);
    EXPECT_NE(error_in("S x"), "");
}

}  // namespace
}  // namespace sunfleck::engine
