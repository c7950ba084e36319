// Where a scene may come from: files of any name, standard input, a shell's pipe.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

class SceneSources : public ProgramTest {
protected:
    /// A line of the shell; "sunfleck" is the program.
    Ran shell(const std::string& line) const {
        return Process(path(""), {"-c", "alias sunfleck=" SUNFLECK_PROGRAM "\n" + line}, "/bin/sh")
            .wait();
    }
};

const std::string kFlags = " --passes 1 --photons-per-pass 2000 --nthreads 1 ";

TEST_F(SceneSources, standard_input_gives_the_picture_of_the_file) {
    const Ran file = shell("sunfleck render room.pbrt -o a.exr --checkpoint a.ckpt" + kFlags);
    const Ran input =
        shell("sunfleck render - -o b.exr --checkpoint b.ckpt" + kFlags + "< room.pbrt");
    ASSERT_EQ(file.code, 0) << file.err;
    ASSERT_EQ(input.code, 0) << input.err;
    EXPECT_EQ(read_text(path("a.exr")), read_text(path("b.exr")));
    const Ran resumed = shell("sunfleck render - --resume b.ckpt -o c.exr --passes 2 < room.pbrt");
    EXPECT_EQ(resumed.code, 2);  // other photons per pass; and not another scene:
    EXPECT_EQ(resumed.err.find("standard input has changed"), std::string::npos) << resumed.err;
    const Ran broken = shell("echo Wrld | sunfleck info -");
    EXPECT_EQ(broken.code, 2);
    EXPECT_EQ(broken.err.find("standard input:1:1: "), 0U) << broken.err;
}

TEST_F(SceneSources, two_dashes_end_the_flags) {
    write_text(path("-odd.pbrt"), read_text(path("room.pbrt")));
    EXPECT_EQ(run({"info", "--", "-odd.pbrt"}).code, 0);
    EXPECT_EQ(run({"info", "--lights", "--", "-odd.pbrt"}).code, 0);
    const Ran late = run({"render", "--", "-odd.pbrt", "-o", "a.exr"});
    EXPECT_EQ(late.code, 2);
    EXPECT_NE(late.err.find("word \"-o\""), std::string::npos) << late.err;
}

TEST_F(SceneSources, pipes_and_folders_are_told_from_missing_files) {
    const Ran pipe = shell("mkfifo p; sunfleck info p");
    EXPECT_EQ(pipe.code, 2);
    EXPECT_NE(pipe.err.find("is a pipe"), std::string::npos) << pipe.err;
    EXPECT_NE(pipe.err.find("standard input, as -"), std::string::npos) << pipe.err;
    EXPECT_NE(run({"info", "/dev/null"}).err.find("is a device"), std::string::npos);
    EXPECT_NE(run({"info", "."}).err.find("is a folder"), std::string::npos);
    EXPECT_NE(run({"info", "ROOM.pbrt"}).err.find("\"room.pbrt\": mind capital letters"),
              std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine
