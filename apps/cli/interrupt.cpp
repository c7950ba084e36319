// Ctrl-C: the first asks the render to end after the pass that runs, the second ends at once.
#include "apps/cli/interrupt.h"

#include "image/atomic_file.h"

#include <unistd.h>

#include <csignal>

namespace sunfleck {
namespace {

std::atomic<bool> interrupted_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal handler may not set it

constexpr int kInterruptedExit = 130;

std::atomic<bool> busy_flag{false};    // ends after the task of finish_first()
std::atomic<bool> ending_flag{false};  // asked twice while busy

void on_signal(int) {
    if (!interrupted_flag.exchange(true)) return;
    ending_flag = true;
    if (busy_flag) return;
    remove_own_temporaries();
    _exit(kInterruptedExit);
}

}  // namespace

InterruptGuard::InterruptGuard() {
    interrupted_flag = false;
    ending_flag = false;
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

void InterruptGuard::finish_first(const std::function<void()>& task) {
    busy_flag = true;
    task();
    busy_flag = false;
    if (!ending_flag) return;
    remove_own_temporaries();
    _exit(kInterruptedExit);
}

const std::atomic<bool>& InterruptGuard::interrupted() {
    return interrupted_flag;
}

}  // namespace sunfleck
