// What stands on a terminal during a render: a line that fits it, and answers to signals.
#include "app/program.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Words;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// The program on a terminal of its own.
class OnTerminal {
public:
    OnTerminal(const std::string& folder, unsigned short columns, const char* kind, Words words) {
        const winsize size{20, columns, 0, 0};
        words.insert(words.begin(), SUNFLECK_PROGRAM);
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        pid_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
        if (pid_ != 0) return;
        // NOLINTNEXTLINE(concurrency-mt-unsafe): a forked process has one thread
        ::setenv("TERM", kind, 1);
        if (::chdir(folder.c_str()) == 0) ::execv(SUNFLECK_PROGRAM, argv.data());
        ::_exit(99);
    }
    ~OnTerminal() { hang_up(); }
    OnTerminal(const OnTerminal&) = delete;
    OnTerminal(OnTerminal&&) = delete;
    OnTerminal& operator=(const OnTerminal&) = delete;
    OnTerminal& operator=(OnTerminal&&) = delete;

    void type(const std::string& keys) const {
        EXPECT_EQ(::write(terminal_, keys.data(), keys.size()), std::ssize(keys));
    }
    void resize(unsigned short columns) const {
        const winsize size{20, columns, 0, 0};
        ::ioctl(terminal_, TIOCSWINSZ, &size);
    }
    void hang_up() {
        if (terminal_ >= 0) ::close(terminal_);
        terminal_ = -1;
    }
    int wait() const {
        int status = 0;
        ::waitpid(pid_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    }
    /// What comes until this text does, or the program ends; at most for a minute.
    std::string read_to(const std::string& text) const {
        std::string all;
        std::array<char, 256> some{};
        for (const auto start = Clock::now(); Clock::now() - start < 60s;) {
            const ssize_t count = ::read(terminal_, some.data(), some.size());
            if (count <= 0) break;
            all.append(some.data(), static_cast<std::size_t>(count));
            if (!text.empty() && all.find(text) != std::string::npos) break;
        }
        return all;
    }

private:
    int terminal_ = -1;
    ::pid_t pid_ = 0;
};

const std::string kErase = "\r\033[J";

/// The longest live line: each is followed by a return to its first column.
std::size_t longest_line(const std::string& text) {
    std::size_t longest = 0;
    for (std::size_t begin = text.find(kErase); begin != std::string::npos;
         begin = text.find(kErase, begin)) {
        begin += kErase.size();
        const std::size_t end = text.find('\r', begin);
        if (end != std::string::npos) longest = std::max(longest, end - begin);
    }
    return longest;
}

class Terminal : public ProgramTest {
protected:
    void SetUp() override {
        const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
        if (terminal < 0) GTEST_SKIP() << "no pseudo-terminals here: is /dev/pts mounted?";
        ::close(terminal);
        ProgramTest::SetUp();
    }
    static Words endless(const std::string& more = "1000000") {
        return {"render", "room.pbrt", "-o", "x.exr", "--photons-per-pass",
                "2000",   "--passes",  more};
    }
};

TEST_F(Terminal, has_one_line_that_fits_also_when_it_shrinks) {
    OnTerminal program(path(""), 40, "xterm", endless());
    const std::string wide = program.read_to(" left\r" + kErase);
    EXPECT_NE(wide.find(" passes, "), std::string::npos) << wide;
    EXPECT_LT(longest_line(wide), 40U);
    EXPECT_EQ(wide.find('\n'), std::string::npos) << wide;
    program.resize(12);
    program.read_to(kErase);
    program.read_to(kErase);
    const std::string narrow = program.read_to(kErase) + program.read_to(kErase);
    EXPECT_LT(longest_line(narrow), 12U);
    EXPECT_GT(longest_line(narrow), 0U) << narrow;
    program.type("\x03");
    const std::string rest = program.read_to("");
    EXPECT_NE(rest.find(kErase + "finishing this pass, then writing"), std::string::npos) << rest;
    const std::string last = rest.substr(rest.rfind(kErase));
    EXPECT_TRUE(last.find("x.exr: ") != std::string::npos && last.ends_with("\n")) << rest;
    EXPECT_EQ(program.wait(), 130);
}

TEST_F(Terminal, that_closes_leaves_the_picture) {
    OnTerminal program(path(""), 80, "xterm", endless());
    program.read_to(" passes, ");
    program.hang_up();
    EXPECT_EQ(program.wait(), 130);
    EXPECT_EQ(names(), "x.exr");
}

TEST_F(Terminal, of_a_kind_that_erases_nothing_gets_whole_lines) {
    OnTerminal program(path(""), 80, "dumb", endless("300"));
    const std::string all = program.read_to("");
    EXPECT_EQ(all.find('\033'), std::string::npos) << all;
    EXPECT_NE(all.find("x.exr: 300 passes, "), std::string::npos) << all;
    EXPECT_EQ(program.wait(), 0);
}

}  // namespace
}  // namespace sunfleck::engine
