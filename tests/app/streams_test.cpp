// Standard streams that are closed, full, or have no reader: messages are lost and nothing else is;
// what a command is asked to print is not lost in silence.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;

class Streams : public ProgramTest {
protected:
    /// Runs a line of the shell, in which $sunfleck is the program.
    Ran shell(const std::string& line) const {
        return Process(path(""), {"-c", "sunfleck=" SUNFLECK_PROGRAM "; " + line}, "/bin/sh")
            .wait();
    }
    std::string picture_of(const std::string& redirection) const {
        const Ran ran = shell(
            "$sunfleck render room.pbrt -o x.exr --passes 2 --photons-per-pass 500 " + redirection);
        EXPECT_EQ(ran.code, 0) << redirection << ran.err;
        std::string bytes = read_text(path("x.exr"));
        std::filesystem::remove(path("x.exr"));
        return bytes;
    }
};

TEST_F(Streams, for_messages_may_be_closed_or_full_or_without_a_reader) {
    const std::string usual = picture_of("");
    ASSERT_FALSE(usual.empty());
    for (const char* redirection :
         {"2>&-", "<&- >&- 2>&-", "2>/dev/full", "2>&1 >/dev/full", "2>&1 | true"})
        EXPECT_EQ(picture_of(redirection), usual) << redirection;
}

TEST_F(Streams, that_lose_what_was_asked_for_are_a_fault) {
    render({"-o", "a.exr", "--passes", "1"});
    for (const char* words :
         {"--help", "--version", "render --help", "info room.pbrt", "info --words", "scene",
          "scene keyhole-4 -o .", "compare a.exr a.exr"})
        for (const char* redirection : {">/dev/full", ">&-"}) {
            const Ran ran = shell(std::string("$sunfleck ") + words + " " + redirection);
            EXPECT_EQ(ran.code, 1) << words << redirection;
            EXPECT_TRUE(ran.err.starts_with("sunfleck: cannot write to standard output: "))
                << ran.err;
        }
    const Ran ran = shell("($sunfleck info --words; echo $? >code) | true; cat code");
    EXPECT_EQ(ran.out, "1\n") << "whose reader has ended: " << ran.err;
}

}  // namespace
}  // namespace sunfleck::engine
