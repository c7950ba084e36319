// Signal handlers that speak, set flags, and end the program when asked twice.
#include "apps/cli/interrupt.h"

#include "apps/cli/messages.h"
#include "image/atomic_file.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace sunfleck::engine {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
constexpr int kInterruptedExit = 130;
constexpr std::int64_t kApart = 1'000'000'000;  // nanoseconds between two that count

std::atomic<bool> interrupted_flag{false};
std::atomic<std::int64_t> interrupted_at{0};  // of the first
std::atomic<bool> busy_flag{false};           // ends after the task of finish_first()
std::atomic<bool> ending_flag{false};         // asked twice while busy
std::atomic<const InterruptAnswer*> present_answer{nullptr};  // set while there is a guard

// Or a signal handler may not use them.
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::int64_t>::is_always_lock_free);
static_assert(std::atomic<const InterruptAnswer*>::is_always_lock_free);

std::int64_t nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void say_if_any(const char* words) {
    if (words != nullptr) say(words);
}

[[noreturn]] void end_at_once() {
    remove_own_temporaries();
    _exit(kInterruptedExit);
}

void on_signal(int signal) {
    const std::int64_t now = nanoseconds();
    const InterruptAnswer& answer = *present_answer.load();
    if (!interrupted_flag.exchange(true)) {
        interrupted_at = now;
        say_if_any(answer.first);
        if (answer.ends) end_at_once();
        return;
    }
    if (signal == SIGHUP || now - interrupted_at < kApart) return;
    if (!ending_flag.exchange(true)) say_if_any(answer.lost);
    if (!busy_flag) end_at_once();
}

bool is_ignored(int signal) {
    struct sigaction now {};
    return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

InterruptGuard::InterruptGuard(const InterruptAnswer& answer) {
    interrupted_flag = false;
    ending_flag = false;
    set_answer(answer);
    for (const int signal : kSignals)
        if (!is_ignored(signal)) std::signal(signal, on_signal);
}

InterruptGuard::~InterruptGuard() {
    for (const int signal : kSignals)
        if (!is_ignored(signal)) std::signal(signal, SIG_DFL);
}

void InterruptGuard::set_answer(const InterruptAnswer& answer) {
    present_answer = &answer;
}

void InterruptGuard::finish_first(const std::function<void()>& task) {
    busy_flag = true;
    task();
    busy_flag = false;
    if (ending_flag) end_at_once();
}

const std::atomic<bool>& InterruptGuard::interrupted() {
    return interrupted_flag;
}

}  // namespace sunfleck::engine
