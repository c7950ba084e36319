// What the machine does not have is told in one line before the work, and ends no program by force.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

/// Sanitizers take much address space, and stand before any library that is loaded first.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasSanitizer = true;
#else
constexpr bool kHasSanitizer = false;
#endif

using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::Words;
using testing_support::operator+;

class MachineLimits : public ProgramTest {
protected:
    static void expect_told(const Ran& ran, int code, const Words& texts) {
        EXPECT_EQ(ran.code, code) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        for (const std::string& text : texts)
            EXPECT_NE(ran.err.find(text), std::string::npos) << text << ": " << ran.err;
    }
    /// Runs the program after a line of shell.
    Ran after(const std::string& line, const Words& words) const {
        const Words start{"-c", line + "; exec \"$0\" \"$@\"", SUNFLECK_PROGRAM};
        return Process(path(""), start + words, "/bin/sh").wait();
    }
};

const Words kRender{"render", "room.pbrt", "--quiet", "-o", "x.exr", "--photons-per-pass",
                    "500",    "--passes",  "1"};

TEST_F(MachineLimits, of_memory_refuse_a_picture_that_is_too_large) {
    expect_told(run(kRender + Words{"--resolution", "16384x16384"}), 2,
                {"16384 x 16384 pixels need about", "--resolution"});
    expect_told(run(kRender + Words{"--resolution", "1000x1000", "--memory-limit", "300M"}), 2,
                {"1000 x 1000 pixels", "there are 300 MiB (--memory-limit)"});
    expect_told(run(kRender + Words{"--memory-limit", "many"}), 2, {"--memory-limit", "512M"});
    EXPECT_EQ(names(), "");
    EXPECT_EQ(run(kRender + Words{"--memory-limit", "1GiB"}).code, 0);
}

TEST_F(MachineLimits, of_address_space_are_counted) {
    if (kHasSanitizer) GTEST_SKIP() << "not with a sanitizer";
    expect_told(after("ulimit -v 1000000", kRender + Words{"--resolution", "1000x1000"}), 2,
                {"1000 x 1000 pixels", "ulimit -v"});
    EXPECT_EQ(names(), "");
}

/// However little there is: no abort, and no file.
TEST_F(MachineLimits, of_address_space_end_no_program_by_a_signal) {
    if (kHasSanitizer) GTEST_SKIP() << "not with a sanitizer";
    for (const int kibibytes : {60000, 100000, 150000, 200000}) {
        const Ran ran = after("ulimit -v " + std::to_string(kibibytes), kRender);
        EXPECT_TRUE(ran.code == 1 || ran.code == 2 || ran.code == 127 || ran.code == 0)
            << kibibytes << ": " << ran.code << " " << ran.err;
        EXPECT_LE(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_EQ(names(), ran.code == 0 ? "x.exr" : "");
    }
}

TEST_F(MachineLimits, of_threads_are_told_with_how_many_there_are) {
    if (kHasSanitizer) GTEST_SKIP() << "not with a sanitizer";
    expect_told(after("export LD_PRELOAD=" SUNFLECK_FAULTS " SUNFLECK_FAULT=thread:2",
                      kRender + Words{"--nthreads", "4"}),
                1, {"4 threads were asked for, but the machine gives 2", "ulimit -u"});
    EXPECT_EQ(names(), "");
}

TEST_F(MachineLimits, info_tells_how_much_memory_a_render_needs) {
    const Ran ran = run({"info", "room.pbrt"});
    EXPECT_NE(ran.out.find("memory      about "), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find(" MiB to render, "), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace sunfleck::engine
