// The thread that draws the progress line.
#include "apps/cli/progress.h"

#include "apps/cli/messages.h"
#include "apps/cli/progress_text.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace sunfleck::engine {
namespace {

/// May it be written on: standard error is one whose lines can be erased?
bool has_terminal() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing changes the environment
    const char* const kind = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
}

/// A job in the background leaves the terminal to whoever works there.
bool is_in_background() {
    return ::tcgetpgrp(STDERR_FILENO) != ::getpgrp();
}

/// Characters that a line may have; the last column stays free, for some terminals fold there.
std::size_t terminal_width() {
    winsize size{};
    constexpr std::size_t kUsual = 80;
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsual - 1;
    return size.ws_col - 1U;
}

}  // namespace

ProgressLine::ProgressLine(bool wanted) {
    if (!wanted) return;
    try {
        thread_ = std::thread([this] { draw_until_over(); });
    } catch (const std::system_error&) {
        // No thread is to be had: the render may go on without a line.
    }
}

ProgressLine::~ProgressLine() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void ProgressLine::show(const Progress& progress) {
    const std::lock_guard lock(mutex_);
    shown_ = {progress, {}};
}

void ProgressLine::draw_until_over() {
    constexpr std::chrono::milliseconds kLive{200};
    constexpr std::chrono::milliseconds kPlain{10'000};
    constexpr std::size_t kWide = 200;
    const bool is_live = has_terminal();
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, is_live ? kLive : kPlain, [this] { return is_over_; })) {
        const std::string text = text_now(is_live ? terminal_width() : kWide);
        lock.unlock();  // writing may take any time
        if (!is_live)
            say(text);
        else if (!is_in_background())
            draw_live_line(text);
        lock.lock();
    }
    if (is_live && !is_in_background()) draw_live_line("");
}

/// What was shown, with the time that has gone since.
std::string ProgressLine::text_now(std::size_t width) const {
    if (!shown_) return reading_text(reading_.seconds(), width);
    Progress now = shown_->progress;
    const double since = shown_->since.seconds();
    now.seconds += since;
    if (now.seconds_left) now.seconds_left = std::max(0.0, *now.seconds_left - since);
    return progress_text(now, width);
}

}  // namespace sunfleck::engine
