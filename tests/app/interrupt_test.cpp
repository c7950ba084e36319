// Ctrl-C: the first ends the render after the pass that runs and writes the picture, or at once
// where there is none yet; the second ends at once; neither leaves half of a file.
#include "app/program.h"
#include "image/exr.h"

#include <sys/stat.h>

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

class Interrupt : public ProgramTest {
protected:
    /// Would run for days; each pass takes as long as its photons, and none needs learning.
    static Words endless(const std::string& photons) {
        return {"render",
                "room.pbrt",
                "-o",
                "x.exr",
                "-o",
                "x.film",
                "--stats",
                "x.json",
                "--passes",
                "100000000",
                "--photon-sampler",
                "uniform",
                "--photons-per-pass",
                photons};
    }

    /// Ended at once by any of the signals, in one line with these words, and no file has changed.
    /// @param begin  starts the program, and waits until it does what is to be interrupted.
    template <class Begin>
    void expect_ends_at_once(const Begin& begin, const std::string& said) const {
        const std::string before = names();
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
            Process process = begin();
            const auto start = Clock::now();
            process.send(signal);
            const Ran ran = process.wait();
            EXPECT_EQ(ran.code, 130);
            EXPECT_LT(Clock::now() - start, 5s);  // else it takes for ever
            EXPECT_EQ(ran.err.find(said), 0U) << ran.err;
            EXPECT_NE(ran.err.find("no picture is written"), std::string::npos) << ran.err;
            EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
            EXPECT_EQ(names(), before);
        }
    }
};

TEST_F(Interrupt, first_writes_the_picture) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Process process(path(""), endless("2000"));
        ASSERT_TRUE(wait_for_render());
        std::this_thread::sleep_for(100ms);
        process.send(signal);
        const Ran ran = process.wait();
        EXPECT_EQ(ran.code, 130) << ran.err;
        EXPECT_NE(ran.err.find(" pass, then writing the picture; interrupt again"),
                  std::string::npos)
            << ran.err;
        EXPECT_EQ(names(), "x.exr x.film x.json");
        const Picture picture = read_exr(path("x.exr"));
        EXPECT_EQ(picture.width, 16);
        EXPECT_GT(picture.find("G")->values[0], 0);
        EXPECT_GE(json("x.json")["passes"], 1);
        // What was rendered is a render of so many passes, to the bit.
        const std::string passes = json("x.json")["passes"].dump();
        ASSERT_EQ(
            render({"-o", "y.exr", "--passes", passes, "--quiet", "--photon-sampler", "uniform"})
                .code,
            0);
        EXPECT_EQ(read_exr(path("y.exr")), picture);
        std::filesystem::remove(path("y.exr"));
    }
}

/// The scene comes through a pipe that never ends.
TEST_F(Interrupt, while_reading_ends_at_once) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    Words words = endless("2000");
    words[1] = "-";
    const Words shell{"-c", "exec 0<>pipe; exec " SUNFLECK_PROGRAM " \"$@\"", "sh"};
    const auto begin = [&] {
        Process process(path(""), shell + words, "/bin/sh");
        EXPECT_TRUE(process.wait_for_handler());
        return process;
    };
    expect_ends_at_once(begin, "interrupted while reading the scene: ");
    ASSERT_EQ(render({"-o", "x.exr", "--quiet", "--passes", "1", "--checkpoint", "x.ckpt"}).code,
              0);
    words = words + Words{"--resume", "x.ckpt", "--checkpoint", "x.ckpt"};
    expect_ends_at_once(begin, "interrupted while reading the scene: ");
}

TEST_F(Interrupt, while_learning_before_the_first_pass_ends_at_once) {
    write_text(path("x.exr"), "an earlier picture");
    Words words = endless("40000000");
    std::replace(words.begin(), words.end(), std::string("uniform"), std::string("adaptive"));
    const auto begin = [&] {
        Process process(path(""), words);
        EXPECT_TRUE(wait_for_render());
        std::this_thread::sleep_for(300ms);
        return process;
    };
    expect_ends_at_once(begin, "interrupted before the first pass: ");
    EXPECT_EQ(read_text(path("x.exr")), "an earlier picture");
}

TEST_F(Interrupt, second_ends_at_once_without_files) {
    Process process(path(""), endless("40000000"));
    ASSERT_TRUE(wait_for_render());
    process.send(SIGINT);
    std::this_thread::sleep_for(1100ms);
    const auto start = Clock::now();
    process.send(SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 130);
    EXPECT_LT(Clock::now() - start, 5s);  // a pass takes many minutes
    EXPECT_NE(ran.err.find("no picture is written"), std::string::npos) << ran.err;
    EXPECT_EQ(names(), "");
}

/// Fingers repeat themselves, and a terminal that closes sends a hang-up more than once.
TEST_F(Interrupt, second_that_comes_at_once_does_not_count) {
    for (const int signal : {SIGINT, SIGHUP}) {
        Process process(path(""), endless("1000000"));
        ASSERT_TRUE(wait_for_render());
        process.send(signal);
        std::this_thread::sleep_for(50ms);
        process.send(signal);
        const Ran ran = process.wait();
        EXPECT_EQ(ran.code, 130);
        EXPECT_EQ(ran.err.find("lost"), std::string::npos) << ran.err;
        EXPECT_EQ(names(), "x.exr x.film x.json");
        for (const char* name : {"x.exr", "x.film", "x.json"}) std::filesystem::remove(path(name));
    }
}

/// As `nohup` does.
TEST_F(Interrupt, signals_that_were_ignored_stay_ignored) {
    Words words{"-c", "trap '' HUP; exec " SUNFLECK_PROGRAM " \"$@\"", "sh"};
    Process process(path(""), words + endless("2000"), "/bin/sh");
    ASSERT_TRUE(wait_for_render());
    process.send(SIGHUP);
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(::waitpid(process.id(), nullptr, WNOHANG), 0) << "the render has ended";
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 130);
}

/// The second comes while a file is being written: that file is finished.
TEST_F(Interrupt, second_while_writing_leaves_no_half) {
    Process process(path(""), endless("200") + Words{"--resolution", "800x600"});
    ASSERT_TRUE(wait_for_render());
    process.send(SIGINT);
    const auto start = Clock::now();
    while (!is_writing() && Clock::now() - start < 60s) std::this_thread::sleep_for(1ms);
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 130);
    EXPECT_EQ(names().find(".part"), std::string::npos);
    EXPECT_EQ(read_exr(path("x.exr")).width, 800);
}

/// Whenever the two come, each file is whole or absent, and nothing else is there.
TEST_F(Interrupt, files_are_whole_or_absent) {
    for (int delay = 0; delay < 12; ++delay) {
        Process process(path(""), endless("200") + Words{"--resolution", "300x200"});
        ASSERT_TRUE(wait_for_render());
        std::this_thread::sleep_for(10ms);
        process.send(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds(3 * delay));
        process.send(SIGINT);
        EXPECT_EQ(process.wait().code, 130);
        for (const auto& entry : std::filesystem::directory_iterator(path("")))
            EXPECT_NE(entry.path().extension(), ".part") << entry.path();
        if (exists("x.exr")) {
            EXPECT_EQ(read_exr(path("x.exr")).width, 300);
        }
        if (exists("x.film")) {
            EXPECT_EQ(run({"merge", "x.film", "-o", "y.png"}).code, 0);
        }
        for (const char* name : {"x.exr", "x.film", "x.json", "y.png"})
            std::filesystem::remove(path(name));
    }
}

}  // namespace
}  // namespace sunfleck::engine
