// Bad input ends with code 2, one line that names it, and no file.
#include "app/program.h"

#include <unistd.h>

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

class ExitCodes : public ProgramTest {
protected:
    void expect_bad_input(const Words& words, const std::string& names_it) const {
        const Ran ran = run(words);
        EXPECT_EQ(ran.code, 2) << names_it;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_NE(ran.err.find(names_it), std::string::npos) << ran.err;
        EXPECT_EQ(ran.out, "");
    }
};

TEST_F(ExitCodes, no_or_unknown_command) {
    expect_bad_input({}, "no command is given; use one of render, info");
    expect_bad_input({"paint"}, "paint");
    expect_bad_input({"render"}, "SCENE");
    expect_bad_input({"info"}, "SCENE");
    expect_bad_input({"info", "room.pbrt", "--passes", "1"}, "--passes");
    expect_bad_input({"render", "room.pbrt", "--spp", "1", "--passes", "1"},
                     "--passes: is given twice; give it once");
}

TEST_F(ExitCodes, missing_scene) {
    expect_bad_input({"render", "missing.pbrt", "-o", "x.exr"}, "missing.pbrt");
    expect_bad_input({"info", "missing.pbrt"}, "missing.pbrt");
    expect_bad_input({"render", ".", "-o", "x.exr"}, ".");
    EXPECT_EQ(names(), "");
}

TEST_F(ExitCodes, broken_scene) {
    write_text(path("broken.pbrt"), "WorldBegin\nShape \"sphere\" \"float radius\" [nonsense]\n");
    expect_bad_input({"render", "broken.pbrt", "-o", "x.exr"}, "broken.pbrt:2");
    expect_bad_input({"info", "broken.pbrt"}, "broken.pbrt:2");
    EXPECT_EQ(names(), "");
}

TEST_F(ExitCodes, missing_mesh_file) {
    write_text(path("mesh.pbrt"), "WorldBegin\nShape \"plymesh\" \"string filename\" \"no.ply\"\n");
    expect_bad_input({"render", "mesh.pbrt", "-o", "x.exr"}, "no.ply");
    EXPECT_EQ(names(), "");
}

using testing_support::operator+;

/// Would take days.
const Words kSlow{"render", "room.pbrt", "--photons-per-pass", "1000000000", "--passes", "100"};

TEST_F(ExitCodes, outputs_are_tried_before_the_render) {
    expect_bad_input(kSlow + Words{"-o", "no/such/folder/x.exr"}, "no/such/folder");
    expect_bad_input(kSlow + Words{"-o", "x.exr", "--stats", "no/x.json"}, "no/x.json");
    expect_bad_input(kSlow + Words{"--stats", "no/x.json"}, "no/x.json");
    expect_bad_input(kSlow + Words{"-o", "x.exr", "-o", "x.bmp"}, "bmp");
    expect_bad_input(kSlow + Words{"-o", "."}, ".");
    expect_bad_input(kSlow + Words{"-o", ""}, "");
    EXPECT_EQ(names(), "");
}

TEST_F(ExitCodes, folder_without_permission) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    std::filesystem::create_directory(path("closed"));
    std::filesystem::permissions(path("closed"), std::filesystem::perms::owner_read);
    expect_bad_input(kSlow + Words{"-o", "closed/x.exr"}, "closed/x.exr");
}

/// A file that stands there already is left alone by bad input.
TEST_F(ExitCodes, earlier_pictures_stay) {
    write_text(path("x.exr"), "earlier");
    expect_bad_input({"render", "missing.pbrt", "-o", "x.exr"}, "missing.pbrt");
    expect_bad_input({"render", "room.pbrt", "-o", "x.exr", "--passes", "none"}, "--passes");
    EXPECT_EQ(read_text(path("x.exr")), "earlier");
}

TEST_F(ExitCodes, scene) {
    expect_bad_input({"scene", "atlantis"}, "atlantis");
    write_text(path("file"), "");
    expect_bad_input({"scene", "cornell", "-o", "file/folder"}, "file");
    EXPECT_EQ(names(), "file");
}

TEST_F(ExitCodes, merge) {
    write_text(path("no.film"), "this is no film");
    expect_bad_input({"merge", "no.film", "-o", "x.exr"}, "no.film");
    expect_bad_input({"merge", "missing.film", "-o", "x.exr"}, "missing.film");
    expect_bad_input({"merge", "-o", "x.exr"}, "FILES");
    expect_bad_input({"merge", "no.film"}, "--output");
    EXPECT_EQ(names(), "no.film");
}

TEST_F(ExitCodes, help_and_version) {
    for (const Words& words : {Words{"--help"}, {"render", "--help"}, {"merge", "-h"}}) {
        const Ran ran = run(words);
        EXPECT_EQ(ran.code, 0);
        EXPECT_EQ(ran.err, "");
        EXPECT_NE(ran.out.find("Usage"), std::string::npos) << ran.out;
    }
    const Ran version = run({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out, "sunfleck " SUNFLECK_VERSION "\n");
}

}  // namespace
}  // namespace sunfleck::engine
