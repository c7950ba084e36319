// The progress line on standard error.
#include "apps/cli/progress.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace sunfleck {
namespace {

/// In 3 levels; of groups of lights, in 0 and 3 levels.
std::string levels_text(const Progress& p) {
    const bool grouped = p.levels.size() > 1;
    if (!grouped && (p.levels.empty() || p.levels.front() == 0)) return {};
    const bool one = !grouped && p.levels.front() == 1;
    return fmt::format(" in {} level{}, {:.0f}% accepted", fmt::join(p.levels, " and "),
                       one ? "" : "s", 100 * p.acceptance);
}

std::string progress_text(const Progress& p) {
    std::string text =
        p.of ? fmt::format("pass {} of {}", p.passes, *p.of) : fmt::format("pass {}", p.passes);
    text +=
        fmt::format(", {}, {:.3g} M paths/s", duration_text(p.seconds), p.paths_per_second * 1e-6);
    if (p.visible_fraction > 0) text += fmt::format(", visible {:.2g}", p.visible_fraction);
    text += levels_text(p);
    if (p.starved > 0) text += fmt::format(", {} starved", p.starved);
    if (p.error) text += fmt::format(", error {:.2f}%", 100 * p.error->value());
    if (p.error && p.error->bias > 0)
        text += fmt::format(", of which bias {:.2f}%", 100 * p.error->bias);
    if (p.target) text += fmt::format(" (target {:.2g}%)", 100 * *p.target);
    if (p.seconds_left) text += fmt::format(", {} left", duration_text(*p.seconds_left));
    return text;
}

}  // namespace

std::string duration_text(double seconds) {
    const auto s = static_cast<long>(std::ceil(seconds));
    if (s < 60) return fmt::format("{}s", s);
    if (s < 3600) return fmt::format("{}m{:02}s", s / 60, s % 60);
    return fmt::format("{}h{:02}m", s / 3600, s / 60 % 60);
}

ProgressLine::ProgressLine(bool wanted) : terminal_(wanted && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
    if (shown_) std::fputc('\n', stderr);
}

void ProgressLine::show(const Progress& progress) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (shown_ && now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r\033[K%s", progress_text(progress).c_str());
    std::fflush(stderr);
}

}  // namespace sunfleck
