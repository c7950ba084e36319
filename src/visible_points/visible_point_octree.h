// VisiblePointOctree: the importance function of multilevel splitting, the proximity of a position
// to the visible points.
//
// In:  visible points. Out: heights of positions. The height is the depth of the finest cell of a
// fixed octree over the scene that contains both the position and part of a gather disc; all passes
// share that scale. Positions that a disc may reach are in full cells, which are higher than all
// others. Every cell that a disc's box touches is marked, so that the sets { height >= h } are
// nested and contain everything visible.
// Equations: docs/method/sampling.md, eq. (11).
#pragma once

#include "visible_points/visible_point.h"

#include <array>
#include <span>
#include <vector>

namespace sunfleck::engine {

class VisiblePointOctree {
public:
    /// Maximum depth of cells.
    static constexpr int kDeepest = 24;
    /// Height of positions in full cells; no disc can reach any other position.
    static constexpr int kFull = kDeepest + 1;

    /// @param points  neighbours in the list should be neighbours in space.
    /// @param centre, radius  of a sphere around the scene, the same for every pass.
    VisiblePointOctree(std::span<const VisiblePoint> points, const Vec3d& centre, double radius);

    /// Returns the height: 0 to kDeepest, or kFull.
    int height(const Vec3& place) const {
        const Vec3d scaled = (Vec3d(place) - low_) * cells_per_unit_;
        const auto inside = [](double x) { return x >= 0 && x < double{1U << kDeepest}; };
        if (!inside(scaled.x) || !inside(scaled.y) || !inside(scaled.z)) return 0;
        const auto x = static_cast<std::uint32_t>(scaled.x);
        const auto y = static_cast<std::uint32_t>(scaled.y);
        const auto z = static_cast<std::uint32_t>(scaled.z);
        std::uint32_t node = 0;
        for (int depth = 0; depth < kDeepest; ++depth) {
            const int bit = kDeepest - 1 - depth;
            node = nodes_[node][(x >> bit & 1U) | (y >> bit & 1U) << 1U | (z >> bit & 1U) << 2U];
            if (node == kEmptyCell) return depth;
            if (node == kFullCell) return kFull;
        }
        return kDeepest;
    }

private:
    static constexpr std::uint32_t kEmptyCell = 0;  // the root is no node's child
    static constexpr std::uint32_t kFullCell = 0xFFFFFFFF;
    using Node = std::array<std::uint32_t, 8>;  // by octant: a node, kEmptyCell or full

    struct Cells {
        std::array<std::uint32_t, 3> low;
        std::array<std::uint32_t, 3> high;
        int depth;
        friend bool operator==(const Cells&, const Cells&) = default;
    };

    using Nodes = std::vector<Node>;

    Cells cells_of(const Disc& disc) const;
    Nodes nodes_over(std::span<const VisiblePoint> points) const;
    static void fill(Nodes& nodes, const Cells& cells);
    static void fill(Nodes& nodes, const std::array<std::uint32_t, 3>& cell, int depth);
    /// Returns the union of octrees. A node that only one of them has is copied.
    static Nodes united(const std::vector<Nodes>& parts);
    static void unite(Nodes& nodes, std::uint32_t into, std::uint32_t other);

    Vec3d low_;
    double cells_per_unit_;  // cells of the deepest level
    Nodes nodes_;
};

}  // namespace sunfleck::engine
