// What the progress line says, and the thread that draws it.
#include "apps/cli/progress.h"

#include "apps/cli/messages.h"
#include "math/wavelengths.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

namespace sunfleck::engine {
namespace {

std::string count_text(std::uint64_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "es");
}

/// Two digits that count: 0.042%, 1.9%, 34%.
std::string share_text(double share) {
    const double percent = 100 * share;
    return percent >= 10 ? fmt::format("{:.0f}%", percent) : fmt::format("{:.2g}%", percent);
}

struct Part {
    int rank;  // the least matters most
    std::string text;
};

/// The error, and what is wanted of it.
void add_error(const Progress& p, std::vector<Part>& parts) {
    if (p.error) {
        parts.push_back({2, "error " + share_text(p.error->value())});
        if (p.error->bias > 0)
            parts.push_back({6, fmt::format("noise {} and bias {}", share_text(p.error->noise),
                                            share_text(p.error->bias))});
    } else if (p.target) {
        parts.push_back(
            {5, fmt::format("error known after {} passes", kTargetBatches * kBatchPasses)});
    }
    if (p.target)
        parts.push_back({4, (p.error ? "target " : "target error ") + share_text(*p.target)});
}

/// Until the error is known, nobody knows when it comes to its target.
std::string left_text(const Progress& p) {
    const bool at_most = p.target && !p.error;
    return (at_most ? "at most " : "") + duration_text(std::ceil(*p.seconds_left)) + " left";
}

std::vector<Part> parts_of(const Progress& p) {
    const std::string learning = "learning where photons are needed";
    if (p.passes == 0)
        return {{0, p.is_learning ? learning : "first pass"}, {1, duration_text(p.seconds)}};
    std::vector<Part> parts{{0, p.of ? fmt::format("{} of {}", p.passes, count_text(*p.of, "pass"))
                                     : count_text(p.passes, "pass")},
                            {1, duration_text(p.seconds)}};
    add_error(p, parts);
    if (p.seconds_left) parts.push_back({3, left_text(p)});
    if (p.is_learning) parts.push_back({4, learning});
    if (p.bringing > 0) parts.push_back({5, share_text(p.bringing) + " of photons are seen"});
    return parts;
}

/// As much as there is room for.
std::string joined(const std::vector<Part>& parts, std::size_t width) {
    for (int last = 6; last >= 0; --last) {
        std::string text;
        for (const Part& part : parts)
            if (part.rank <= last) text += (text.empty() ? "" : ", ") + part.text;
        if (text.size() <= width) return text;
    }
    const std::string& first = parts.front().text;
    return first.substr(0, std::min(width, first.find(' ')));
}

/// May it be written on: standard error is one whose lines can be erased?
bool has_terminal() {
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

std::string duration_text(double seconds) {
    const auto s = std::lround(seconds);
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{}m{:02}s", s / 60, s % 60);
    return fmt::format("{}h{:02}m", s / 3600, s / 60 % 60);
}

std::string state_text(std::uint64_t passes, double seconds, std::optional<TargetError> error) {
    const std::string time = seconds < 0.1    ? "less than 0.1 s"
                             : seconds < 9.95 ? fmt::format("{:.2g} s", seconds)
                                              : duration_text(seconds);
    std::string text = count_text(passes, "pass") + ", " + time;
    if (error) text += fmt::format(", error {} (95% of blocks)", share_text(error->value()));
    return text;
}

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
    if (!shown_)
        return joined({{0, "reading the scene"}, {1, duration_text(reading_.seconds())}}, width);
    Progress now = shown_->progress;
    const double since = shown_->since.seconds();
    now.seconds += since;
    if (now.seconds_left) now.seconds_left = std::max(0.0, *now.seconds_left - since);
    return joined(parts_of(now), width);
}

}  // namespace sunfleck::engine
