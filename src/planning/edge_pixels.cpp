// One probe often misses what is over an edge, but hardly ever do those of all neighbours.
#include "planning/edge_pixels.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kReach = 2;          // in pixels: 25 discs and more vote for one
constexpr int kFewVotes = 8;       // as at an outline, or of a surface that is hardly there
constexpr float kNoticed = 0.01F;  // of a factor of light

/// Returns what the discs of a point have found.
Edge edge_of(const VisiblePoint& point) {
    if (point.needs_sight) return Edge::of_sight;
    const float most = std::max(std::abs(point.disc_over_surface - 1),
                                std::abs(point.indirect_disc_over_surface - 1));
    return most > kNoticed ? Edge::of_surface : Edge::none;
}

/// Calls visit(pixel) for the pixels within kReach of one, and for itself.
template <class Visit>
void for_near(const PixelWindow& window, std::uint32_t pixel, const Visit& visit) {
    const int x = static_cast<int>(pixel) % window.width();
    const int y = static_cast<int>(pixel) / window.width();
    for (int v = std::max(0, y - kReach); v <= std::min(window.height() - 1, y + kReach); ++v)
        for (int u = std::max(0, x - kReach); u <= std::min(window.width() - 1, x + kReach); ++u)
            visit(static_cast<std::size_t>(v * window.width() + u));
}

}  // namespace

EdgePixels edge_pixels(const CameraTrial& seen, const PixelWindow& window) {
    EdgePixels pixels(window.pixels(), Edge::none);
    std::vector<std::uint8_t> votes(window.pixels());  // pixels near each that have a disc
    std::vector<bool> has_voted(window.pixels());
    for (const VisiblePoint& point : seen.index.points()) {
        const Edge edge = edge_of(point);
        if (edge != Edge::none)
            for_near(window, point.pixel,
                     [&](std::size_t i) { pixels[i] = std::max(pixels[i], edge); });
        if (has_voted[point.pixel]) continue;
        has_voted[point.pixel] = true;
        for_near(window, point.pixel, [&](std::size_t i) { ++votes[i]; });
    }
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (votes[i] < kFewVotes) pixels[i] = Edge::of_sight;
    return pixels;
}

}  // namespace sunfleck::engine
