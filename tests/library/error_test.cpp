// Tests sunfleck/error.h: the one line that a user reads.
#include <gtest/gtest.h>
#include <sunfleck/error.h>

#include <stdexcept>

namespace sunfleck::engine {
namespace {

TEST(Error, says_place_fault_and_remedy_in_one_line) {
    const Error error({"lamp.pbrt", 12, 8}, "unknown material \"glas\"", "use \"dielectric\"");
    EXPECT_STREQ(error.what(), "lamp.pbrt:12:8: unknown material \"glas\"; use \"dielectric\"");
    EXPECT_EQ(error.where().file, "lamp.pbrt");
    EXPECT_EQ(error.where().line, 12);
    EXPECT_EQ(error.where().column, 8);
}

TEST(Error, the_file_as_a_whole_has_no_line) {
    const Error error({"out.exr"}, "there is no such file", "check the name");
    EXPECT_STREQ(error.what(), "out.exr: there is no such file; check the name");
}

TEST(Error, is_a_runtime_error) {
    EXPECT_THROW(throw Error({"a"}, "b", "c"), std::runtime_error);
}

}  // namespace
}  // namespace sunfleck::engine
