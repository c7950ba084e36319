// An implicit tree of bounding boxes over anything that stands in Morton order.
//
// Node j of a level holds the boxes of nodes 8j .. 8j + 7 of the level below, the lowest level the
// boxes of eight leaves. No pointers, built in one sweep a level, whatever the spread of the sizes.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace sunfleck::engine {

/// Closed; empty until extended.
struct Box {
    Vec3 low{std::numeric_limits<float>::infinity()};
    Vec3 high{-std::numeric_limits<float>::infinity()};

    void extend(const Box& other) {
        for (int c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], other.low[c]);
            high[c] = std::max(high[c], other.high[c]);
        }
    }
};

/// Boxes of eight children, one array a coordinate.
struct alignas(64) BoxNode {
    static constexpr std::size_t kWidth = 8;
    std::array<std::array<float, kWidth>, 3> low;
    std::array<std::array<float, kWidth>, 3> high;
};

class BoxTree {
public:
    BoxTree() = default;
    /// @param leaves  their boxes, neighbours in space near each other in the list.
    explicit BoxTree(std::vector<Box> leaves);

    /// Calls go_on(leaf) for leaves that are touched, always in the same order, until it says
    /// false.
    /// @param touched  of a BoxNode: bit i is set if child i is. @return whether go_on() did.
    template <class Touched, class GoOn>
    [[gnu::always_inline]] inline bool visit(const Touched& touched, const GoOn& go_on) const {
        return !levels_.empty() && descend(touched, 0, go_on);
    }

    /// Appends the lowest nodes that are touched, always in the same order: node(j) is over leaves
    /// 8 j .. 8 j + 7.
    template <class Touched>
    [[gnu::always_inline]] inline void append_nodes(const Touched& touched,
                                                    std::vector<std::uint32_t>& nodes) const {
        if (levels_.size() == 1) nodes.push_back(0);
        if (levels_.size() < 2) return;
        descend(touched, 1, [&](std::uint32_t node) {
            nodes.push_back(node);
            return true;
        });
    }
    const BoxNode& node(std::uint32_t lowest) const { return levels_[0][lowest]; }

    std::size_t bytes() const {
        std::size_t total = 0;
        for (const auto& level : levels_) total += level.size() * sizeof(BoxNode);
        return total;
    }

private:
    static constexpr std::uint32_t kWidth = BoxNode::kWidth;
    struct Entry {
        std::uint32_t level;
        std::uint32_t node;
    };

    /// visit(), for what the nodes of level `last` stand over. Inlined as its callers are, so that
    /// what they ask for is compiled for the same processor.
    template <class Touched, class GoOn>
    [[gnu::always_inline]] inline bool descend(const Touched& touched, std::uint32_t last,
                                               const GoOn& go_on) const {
        std::array<Entry, 96> stack;  // 7 a level and 8: enough for 2^32 leaves
        std::size_t top = 0;
        stack[top++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
        while (top > 0) {
            const Entry at = stack[--top];
            unsigned mask = touched(levels_[at.level][at.node]);
            for (; mask != 0; mask &= mask - 1) {
                const std::uint32_t child =
                    at.node * kWidth + static_cast<std::uint32_t>(__builtin_ctz(mask));
                if (at.level > last)
                    stack[top++] = {at.level - 1, child};
                else if (!go_on(child))
                    return true;
            }
        }
        return false;
    }

    std::vector<std::vector<BoxNode>> levels_;  // lowest first; the last has one node
};

}  // namespace sunfleck::engine
