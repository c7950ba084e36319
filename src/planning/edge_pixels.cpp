// One probe often misses what is over an edge, but hardly ever do those of all neighbours.
#include "planning/edge_pixels.h"

#include "camera_paths/edge_tuning.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns what the discs of a point have found. Cylinders are probed anyway.
Edge edge_of(const VisiblePoint& point) {
    if (point.disc.is_in_medium()) return Edge::none;
    if (point.needs_sight) return Edge::of_sight;
    const float most = std::max(std::abs(point.disc_over_surface - 1),
                                std::abs(point.indirect_disc_over_surface - 1));
    return most > kNoticed ? Edge::of_surface : Edge::none;
}

/// Calls visit(i) for the values of a grid within kReach of one, and for itself.
template <class Visit>
void for_near(int across, int down, std::size_t i, const Visit& visit) {
    const int x = static_cast<int>(i) % across;
    const int y = static_cast<int>(i) / across;
    for (int v = std::max(0, y - kReach); v <= std::min(down - 1, y + kReach); ++v)
        for (int u = std::max(0, x - kReach); u <= std::min(across - 1, x + kReach); ++u)
            visit(static_cast<std::size_t>(v * across + u));
}

/// Returns the edges of the cells of a trial.
EdgePixels edge_cells(const CameraTrial& seen, const PixelCells& cells) {
    const auto count =
        static_cast<std::size_t>(cells.across()) * static_cast<std::size_t>(cells.down());
    EdgePixels edges(count, Edge::none);
    std::vector<std::uint8_t> votes(count);  // cells near each that have a disc
    std::vector<bool> has_voted(count);
    for (const VisiblePoint& point : seen.index.points()) {
        const std::size_t cell = cells.cell_of(point.pixel);
        const auto for_near_cells = [&](const auto& visit) {
            for_near(cells.across(), cells.down(), cell, visit);
        };
        const Edge edge = edge_of(point);
        if (edge != Edge::none)
            for_near_cells([&](std::size_t i) { edges[i] = std::max(edges[i], edge); });
        if (has_voted[cell]) continue;
        has_voted[cell] = true;
        for_near_cells([&](std::size_t i) { ++votes[i]; });
    }
    for (std::size_t i = 0; i < count; ++i)
        if (votes[i] < kFewVotes) edges[i] = Edge::of_sight;
    return edges;
}

}  // namespace

EdgePixels edge_pixels(const CameraTrial& seen, const PixelWindow& window) {
    const PixelCells cells{window, seen.cells};
    const EdgePixels of_cells = edge_cells(seen, cells);
    EdgePixels pixels(window.pixels());
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = of_cells[cells.cell_of(i)];
    return pixels;
}

}  // namespace sunfleck::engine
