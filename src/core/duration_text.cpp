// Seconds, minutes and hours.
#include "core/duration_text.h"

#include <fmt/format.h>

#include <cmath>

namespace sunfleck::engine {

std::string duration_text(double seconds) {
    const auto s = std::lround(seconds);
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{}m{:02}s", s / 60, s % 60);
    return fmt::format("{}h{:02}m", s / 3600, s / 60 % 60);
}

}  // namespace sunfleck::engine
