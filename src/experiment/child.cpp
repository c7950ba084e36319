// posix_spawn, and waiting with polls for interruptions.
#include "experiment/child.h"

#include "image/read_file.h"
#include "sunfleck/error.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

extern char** environ;  // NOLINT(readability-redundant-declaration): glibc has it for GNU alone

namespace sunfleck::engine {
namespace {

std::string last_line(const std::string& path) {
    std::string text = read_file(path);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.find_last_of('\n') + 1);
}

}  // namespace

void check_render(const ChildEnd& end, const std::string& log) {
    if (end.code != 0)
        throw Error({log},
                    fmt::format("the render ended with code {}: {}", end.code, last_line(log)),
                    "run its command by hand for details");
}

ChildEnd run_child(const std::vector<std::string>& words, const std::string& log,
                   const std::atomic<bool>* interrupted) {
    std::vector<std::string> copies = words;
    std::vector<char*> argv;
    argv.reserve(copies.size() + 1);
    for (std::string& word : copies) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&files, 1, 2);
    pid_t child = 0;
    const int fault = posix_spawn(&child, argv[0], &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (fault != 0)
        throw Error({words[0]}, "cannot be started: " + std::system_category().message(fault),
                    "check that you may write to " + log);
    int status = 0;
    rusage usage{};
    bool told = false;
    while (wait4(child, &status, WNOHANG, &usage) == 0) {
        if (interrupted != nullptr && interrupted->load() && !told) {
            kill(child, SIGINT);
            told = true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

}  // namespace sunfleck::engine
