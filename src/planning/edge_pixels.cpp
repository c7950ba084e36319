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

/// A number for each pixel of a window.
struct Counts {
    const PixelWindow& window;
    std::vector<int> values;

    /// Returns the sums over kReach pixels to either side, along rows or columns.
    Counts summed(bool along_rows) const {
        const int length = along_rows ? window.width() : window.height();
        const int lines = along_rows ? window.height() : window.width();
        const int step = along_rows ? 1 : window.width();
        const int next_line = along_rows ? window.width() : 1;
        Counts sums{window, std::vector<int>(values.size())};
        for (int line = 0; line < lines; ++line)
            for (int i = 0; i < length; ++i)
                for (int k = std::max(0, i - kReach); k <= std::min(length - 1, i + kReach); ++k)
                    sums.values[index(line * next_line + i * step)] +=
                        values[index(line * next_line + k * step)];
        return sums;
    }

private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
};

/// Returns how many pixels around each, and with it, have a disc.
Counts votes_of(const CameraTrial& seen, const PixelWindow& window) {
    Counts discs{window, std::vector<int>(window.pixels())};
    for (const VisiblePoint& point : seen.index.points()) discs.values[point.pixel] = 1;
    return discs.summed(true).summed(false);
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
    const Counts votes = votes_of(seen, window);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (votes.values[i] < kFewVotes) pixels[i] = Edge::of_sight;
    return pixels;
}

}  // namespace sunfleck::engine
