// fork, exec, and a wait that can interrupt.
#include "differential/program.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

namespace sunfleck::engine::differential {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int kCannotStart = 127;

[[noreturn]] void become(const std::string& path, const std::string& folder, const Words& words,
                         const std::string& log, int seconds) {
    std::vector<char*> argv = {const_cast<char*>(path.c_str())};
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const auto limit = static_cast<rlim_t>(seconds);
    const rlimit time{limit, limit + 5};
    const rlimit no_core{0, 0};
    // A tester that is killed leaves no render behind, which would write into the next one's
    // folder.
    const bool is_ready = ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 &&
                          ::setrlimit(RLIMIT_CPU, &time) == 0 &&
                          ::setrlimit(RLIMIT_CORE, &no_core) == 0 && ::chdir(folder.c_str()) == 0 &&
                          std::freopen(log.c_str(), "wb", stdout) != nullptr &&
                          ::dup2(STDOUT_FILENO, STDERR_FILENO) >= 0;
    if (is_ready) ::execv(path.c_str(), argv.data());
    ::_exit(kCannotStart);
}

}  // namespace

std::string Ended::text() const {
    const std::string line = said.substr(0, said.find('\n'));
    const std::string how =
        code > 128 ? "signal " + std::to_string(code - 128) : "exit code " + std::to_string(code);
    return line.empty() ? how : how + ": " + line;
}

Ended Program::run(const std::string& folder, const Words& words,
                   std::optional<std::chrono::milliseconds> interrupt_after) const {
    const std::string log = folder + "/said.txt";
    const ::pid_t id = ::fork();
    if (id < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (id == 0) become(path_, folder, words, log, seconds_);
    const auto start = Clock::now();
    int status = 0;
    rusage usage{};
    Ended ended;
    while (::wait4(id, &status, WNOHANG, &usage) == 0) {
        const auto passed = Clock::now() - start;
        if (interrupt_after && passed > *interrupt_after) {
            ::kill(id, SIGINT);
            interrupt_after.reset();
        }
        if (passed > 10s * seconds_) {
            ended.is_late = true;
            ::kill(id, SIGKILL);
        }
        std::this_thread::sleep_for(2ms);
    }
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.is_late |= ended.code == 128 + SIGXCPU;
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    ended.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    std::ifstream file(log, std::ios::binary);
    ended.said = {std::istreambuf_iterator<char>(file), {}};
    return ended;
}

}  // namespace sunfleck::engine::differential
