// Numbers of a render in words.
#include "apps/cli/progress_text.h"

#include "core/duration_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
        parts.push_back({5, fmt::format("error known after {} batches", kTargetBatches)});
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
    if (p.bringing > 0) parts.push_back({5, share_text(p.bringing) + " of photons contribute"});
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

}  // namespace

std::string state_text(std::uint64_t passes, double seconds, std::optional<TargetError> error) {
    const std::string time = seconds < 0.1    ? "less than 0.1 s"
                             : seconds < 9.95 ? fmt::format("{:.2g} s", seconds)
                                              : duration_text(seconds);
    std::string text = count_text(passes, "pass") + ", " + time;
    if (!error) return text;
    text += fmt::format(", error {} (95% of blocks", share_text(error->value()));
    if (error->of_dark) text += fmt::format("; {} of dark ones", share_text(*error->of_dark));
    return text + ")";
}

std::string reading_text(double seconds, std::size_t width) {
    return joined({{0, "reading the scene"}, {1, duration_text(seconds)}}, width);
}

std::string progress_text(const Progress& progress, std::size_t width) {
    return joined(parts_of(progress), width);
}

}  // namespace sunfleck::engine
