// Construction of the octree: disc by disc in parallel subsets, then their union.
#include "visible_points/visible_point_octree.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

namespace {

/// Returns how far from the centre, along any axis, visible points in media reach: a medium may
/// have no end.
double reach_in_media(std::span<const VisiblePoint> points, const Vec3d& centre) {
    double reach = 0;
    for (const VisiblePoint& point : points) {
        const Disc& disc = point.disc;
        if (!disc.is_in_medium()) continue;
        const double half = double{disc.widest_radius()} + double{disc.half_length};
        for (int c = 0; c < 3; ++c)
            reach = std::max(reach, std::abs(double{disc.position[c]} - centre[c]) + half);
    }
    return reach;
}

}  // namespace

/// The root is larger than the scene and shifted, so that walls are not on cell faces.
VisiblePointOctree::VisiblePointOctree(std::span<const VisiblePoint> points, const Vec3d& centre,
                                       double radius) {
    constexpr std::size_t kLeastPart = 4096;
    double size = std::max(2.5 * radius, 1e-30);
    const double reach = reach_in_media(points, centre);
    while (size < 2.5 * reach) size *= 2;  // in steps, so that cells are alike in all passes
    low_ = centre - Vec3d(0.4871, 0.5143, 0.5029) * size;
    cells_per_unit_ = double{1U << kDeepest} / size;
    const std::size_t part = block_of_a_thread(points.size(), kLeastPart);
    std::vector<Nodes> parts((points.size() + part - 1) / part);
    parallel_blocks(points.size(), part, [&](std::size_t begin, std::size_t end) {
        parts[begin / part] = nodes_over(points.subspan(begin, end - begin));
    });
    nodes_ = united(parts);
}

VisiblePointOctree::Nodes VisiblePointOctree::nodes_over(
    std::span<const VisiblePoint> points) const {
    Nodes nodes(1, Node{});
    Cells last{{0, 0, 0}, {0, 0, 0}, -1};
    for (const VisiblePoint& point : points) {
        const Cells cells = cells_of(point.disc);
        if (cells != last) fill(nodes, cells);  // neighbours mostly touch the same cells
        last = cells;
    }
    return nodes;
}

/// Returns the cells at the depth where they are at least as wide as the box, which then touches at
/// most two per axis; never the root, which has no parent to mark it as full.
VisiblePointOctree::Cells VisiblePointOctree::cells_of(const Disc& disc) const {
    constexpr double kLast = double{1U << kDeepest} - 1;
    Cells cells{};
    double widest = 0;
    for (int c = 0; c < 3; ++c) {
        // accepts() allows nothing beyond sqrt(1.5) radii of a disc.
        const double half = 1.23 * double{disc.widest_radius()} +
                            double{disc.half_length} * std::abs(double{disc.normal[c]}) +
                            std::abs(double{disc.position[c]}) * 1e-6;
        const double middle = (double{disc.position[c]} - low_[c]);
        const auto cell = [&](double x) {
            return static_cast<std::uint32_t>(std::clamp(x * cells_per_unit_, 0.0, kLast));
        };
        const auto axis = static_cast<std::size_t>(c);
        cells.low.at(axis) = cell(middle - half);
        cells.high.at(axis) = cell(middle + half);
        widest = std::max(widest, 2 * half * cells_per_unit_);
    }
    int halvings = 0;
    while (halvings + 1 < kDeepest && static_cast<double>(1U << halvings) < widest) ++halvings;
    cells.depth = kDeepest - halvings;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        cells.low.at(axis) >>= halvings;
        cells.high.at(axis) >>= halvings;
    }
    return cells;
}

void VisiblePointOctree::fill(Nodes& nodes, const Cells& cells) {
    for (std::uint32_t z = cells.low[2]; z <= cells.high[2]; ++z)
        for (std::uint32_t y = cells.low[1]; y <= cells.high[1]; ++y)
            for (std::uint32_t x = cells.low[0]; x <= cells.high[0]; ++x)
                fill(nodes, {x, y, z}, cells.depth);
}

void VisiblePointOctree::fill(Nodes& nodes, const std::array<std::uint32_t, 3>& cell, int depth) {
    std::uint32_t node = 0;
    for (int bit = depth - 1; bit >= 0; --bit) {
        const std::size_t child =
            (cell[0] >> bit & 1U) | (cell[1] >> bit & 1U) << 1U | (cell[2] >> bit & 1U) << 2U;
        const std::uint32_t next = nodes[node].at(child);
        if (next == kFullCell) return;
        if (bit == 0) {
            nodes[node].at(child) = kFullCell;
        } else if (next != kEmptyCell) {
            node = next;
        } else {
            const auto added = static_cast<std::uint32_t>(nodes.size());
            nodes[node].at(child) = added;
            nodes.emplace_back();
            node = added;
        }
    }
}

VisiblePointOctree::Nodes VisiblePointOctree::united(const std::vector<Nodes>& parts) {
    if (parts.empty()) return {Node{}};
    std::vector<std::size_t> first(parts.size() + 1, 0);
    for (std::size_t p = 0; p < parts.size(); ++p) first[p + 1] = first[p] + parts[p].size();
    Nodes nodes(first.back());
    parallel_for(parts.size(), [&](std::size_t p) {
        const auto offset = static_cast<std::uint32_t>(first[p]);
        for (std::size_t i = 0; i < parts[p].size(); ++i)
            for (std::size_t c = 0; c < Node().size(); ++c) {
                const std::uint32_t child = parts[p][i][c];
                const bool is_node = child != kEmptyCell && child != kFullCell;
                nodes[first[p] + i][c] = is_node ? child + offset : child;
            }
    });
    for (std::size_t p = 1; p < parts.size(); ++p)
        unite(nodes, 0, static_cast<std::uint32_t>(first[p]));
    return nodes;
}

void VisiblePointOctree::unite(Nodes& nodes, std::uint32_t into, std::uint32_t other) {
    for (std::size_t c = 0; c < Node().size(); ++c) {
        std::uint32_t& cell = nodes[into][c];
        const std::uint32_t added = nodes[other][c];
        if (cell == kFullCell || added == kEmptyCell) continue;
        if (cell == kEmptyCell || added == kFullCell)
            cell = added;
        else
            unite(nodes, cell, added);
    }
}

}  // namespace sunfleck::engine
