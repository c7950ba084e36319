// Files beside a part.
#include "import/part/files.h"

#include "part_files.h"

namespace sunfleck::engine {
namespace {

class Beside : public testing_support::PartFolder {};

TEST_F(Beside, are_found_by_names_of_any_system) {
    written("sub/a b.png", "x");
    const std::string part = written("a.obj", "");
    PartFiles files(part);
    for (const char* name : {"sub/a b.png", "sub\\a b.png", ".\\sub\\a b.png"}) {
        const auto file = files.find(name, part, {part});
        ASSERT_TRUE(file) << name;
        EXPECT_EQ(file->bytes, "x");
    }
    EXPECT_EQ(files.files(), (std::vector<std::string>{part, path("sub/a b.png")}));
    EXPECT_TRUE(files.find("D:\\work\\a b.png", path("sub/x.mtl"), {part}));
    EXPECT_NO_THROW(files.check_missing(""));
}

TEST_F(Beside, that_are_missing_are_told_once_with_a_hint) {
    written("Red.png", "x");
    const std::string part = written("a.obj", "");
    PartFiles files(part);
    EXPECT_FALSE(files.find("red.png", part, {"a.mtl", 3, 1}));
    EXPECT_FALSE(files.find("red.png", part, {"a.mtl", 9, 1}));
    try {
        files.check_missing("");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), part + ": a file is missing: \"" + path("red.png") +
                                                 "\" (a.mtl:3:1): there is \"" + path("Red.png") +
                                                 "\": check upper and lower case; put it there");
    }
}

}  // namespace
}  // namespace sunfleck::engine
