// "Does any disc take this photon?" and "which discs do?", for the visible points of a pass.
//
// In:  visible points. Out: those points in Morton order under an implicit tree of bounding
// boxes: node j of a level covers nodes 8j .. 8j + 7 of the level below, the lowest level covers
// eight discs a node. No pointers, built in one sweep a level, whatever the spread of the radii.
#pragma once

#include "measurement/morton.h"
#include "measurement/visible_point.h"

#include <hwy/highway.h>

#include <array>
#include <vector>

namespace sunfleck {

class VisiblePointIndex {
public:
    /// @param max_depth  scattering events allowed on a whole path (takes()).
    VisiblePointIndex(std::vector<VisiblePoint> points, int max_depth);

    /// V of the paper for one photon: is it taken by any visible point? Ends at the first.
    bool any(const Photon& photon) const {
        return visit(photon, [](const VisiblePoint&) { return false; });
    }

    /// Calls deposit(point) for every visible point that takes the photon.
    template <class Deposit>
    bool for_each(const Photon& photon, const Deposit& deposit) const {
        return visit(photon, [&](const VisiblePoint& point) {
            deposit(point);
            return true;
        });
    }

    /// May any point take a photon there? A quick no for most places that are not seen.
    bool may_take(const Vec3& position) const {
        return !levels_.empty() && levels_.back().front().children_around(position) != 0;
    }

    /// Numbers near each other for places that the tree holds near each other.
    const MortonGrid& grid() const { return grid_; }

    const std::vector<VisiblePoint>& points() const { return points_; }
    std::size_t bytes() const;

private:
    static constexpr std::size_t kWidth = 8;

    /// Boxes of eight children, one array a coordinate: compared four at a time.
    struct alignas(64) Node {
        std::array<std::array<float, kWidth>, 3> low;
        std::array<std::array<float, kWidth>, 3> high;

        /// Bit i is set if p is in the box of child i.
        unsigned children_around(const Vec3& p) const {
            namespace hn = hwy::HWY_NAMESPACE;
            const hn::FixedTag<float, 4> four;
            unsigned mask = 0;
            for (unsigned i = 0; i < kWidth; i += 4) {
                const auto between = [&](std::size_t axis) {
                    const auto x = hn::Set(four, p[static_cast<int>(axis)]);
                    return hn::And(hn::Le(hn::Load(four, &low[axis][i]), x),
                                   hn::Le(x, hn::Load(four, &high[axis][i])));
                };
                std::uint8_t bits = 0;
                hn::StoreMaskBits(four, hn::And(between(0), hn::And(between(1), between(2))),
                                  &bits);
                mask |= static_cast<unsigned>(bits) << i;
            }
            return mask;
        }
    };

    /// Calls go_on(point) for the points that take the photon until it says false.
    /// @return whether any was found.
    template <class GoOn>
    bool visit(const Photon& photon, const GoOn& go_on) const {
        if (levels_.empty()) return false;
        struct Entry {
            std::uint32_t level;
            std::uint32_t node;
        };
        std::array<Entry, 96> stack;  // 7 a level and 8: enough for 2^32 points
        std::size_t top = 0;
        stack[top++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
        bool found = false;
        while (top > 0) {
            const Entry at = stack[--top];
            unsigned mask = levels_[at.level][at.node].children_around(photon.position);
            for (; mask != 0; mask &= mask - 1) {
                const auto child = at.node * static_cast<std::uint32_t>(kWidth) +
                                   static_cast<std::uint32_t>(__builtin_ctz(mask));
                if (at.level > 0) {
                    stack[top++] = {at.level - 1, child};
                } else if (takes(discs_[child], photon, max_depth_)) {
                    found = true;
                    if (!go_on(points_[child])) return true;
                }
            }
        }
        return found;
    }

    int max_depth_;
    MortonGrid grid_;
    std::vector<VisiblePoint> points_;       // in Morton order
    std::vector<Disc> discs_;                // the same order: what a query reads
    std::vector<std::vector<Node>> levels_;  // lowest first; the last has one node
};

}  // namespace sunfleck
