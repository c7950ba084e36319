// One probe often misses what is over an edge, but hardly ever do those of all neighbours.
#include "planning/edge_pixels.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kReach = 2;          // in pixels: 25 discs and more vote for one
constexpr float kNoticed = 0.01F;  // of a factor of light

/// Returns what the discs of a point have found.
Edge edge_of(const VisiblePoint& point) {
    if (point.needs_sight) return Edge::of_sight;
    const float most = std::max(std::abs(point.disc_over_surface - 1),
                                std::abs(point.indirect_disc_over_surface - 1));
    return most > kNoticed ? Edge::of_surface : Edge::none;
}

}  // namespace

EdgePixels edge_pixels(const CameraTrial& seen, const PixelWindow& window) {
    EdgePixels pixels(window.pixels(), Edge::none);
    for (const VisiblePoint& point : seen.index.points()) {
        const Edge edge = edge_of(point);
        if (edge == Edge::none) continue;
        const int x = static_cast<int>(point.pixel) % window.width();
        const int y = static_cast<int>(point.pixel) / window.width();
        for (int v = std::max(0, y - kReach); v <= std::min(window.height() - 1, y + kReach); ++v)
            for (int u = std::max(0, x - kReach); u <= std::min(window.width() - 1, x + kReach);
                 ++u) {
                Edge& pixel = pixels[static_cast<std::size_t>(v * window.width() + u)];
                pixel = std::max(pixel, edge);
            }
    }
    return pixels;
}

}  // namespace sunfleck::engine
