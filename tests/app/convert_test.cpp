// `sunfleck convert` writes all files or none, and replaces nothing unasked.
#include "app/program.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::write_text;

class Convert : public ProgramTest {};

TEST_F(Convert, writes_a_scene_that_is_read_again) {
    write_text(path("a.pbrt"), "WorldBegin\nLightSource \"point\"\nShape \"sphere\"\n");
    const Ran ran = run({"convert", path("a.pbrt"), "-o", path("out/b.pbrt")});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, path("out/b.pbrt") + "\n");
    EXPECT_EQ(run({"info", path("out/b.pbrt")}).code, 0);
    EXPECT_EQ(run({"convert", path("a.pbrt"), "-o", path("out/b.pbrt")}).code, 0);  // the same
}

TEST_F(Convert, replaces_a_file_that_differs_only_if_asked) {
    write_text(path("a.pbrt"), "WorldBegin\nShape \"sphere\"\n");
    write_text(path("b.pbrt"), "mine");
    const Ran ran = run({"convert", path("a.pbrt"), "-o", path("b.pbrt")});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("--force"), std::string::npos) << ran.err;
    EXPECT_EQ(read_text(path("b.pbrt")), "mine");
    EXPECT_EQ(run({"convert", path("a.pbrt"), "-o", path("b.pbrt"), "--force"}).code, 0);
    EXPECT_NE(read_text(path("b.pbrt")).find("WorldBegin"), std::string::npos);
}

TEST_F(Convert, leaves_nothing_where_a_file_cannot_be_written) {
    write_text(path("a.pbrt"), R"(WorldBegin
Texture "t" "spectrum" "imagemap" "string filename" "p.pfm"
Material "diffuse" "texture reflectance" "t"
Shape "sphere"
)");
    write_text(path("p.pfm"), std::string("PF\n1 1\n-1\n") + std::string(12, '\0'));
    std::filesystem::create_directory(path("b.pbrt"));  // where the main file, the last, is to be
    const Ran ran = run({"convert", path("a.pbrt"), "-o", path("b.pbrt"), "--force"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_FALSE(std::filesystem::exists(path("b-files"))) << ran.err;
}

TEST_F(Convert, asks_for_a_name_of_a_pbrt_file) {
    write_text(path("a.pbrt"), "WorldBegin\n");
    const Ran ran = run({"convert", path("a.pbrt"), "-o", path("b.txt")});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find(".pbrt"), std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine
