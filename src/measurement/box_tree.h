// An implicit tree of bounding boxes over anything that stands in Morton order.
//
// Node j of a level holds the boxes of nodes 8j .. 8j + 7 of the level below, the lowest level the
// boxes of eight leaves. No pointers, built in one sweep a level, whatever the spread of the sizes.
#pragma once

#include "math/vector.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace sunfleck {

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

/// Four floats compared at once.
using FourFloats = hwy::HWY_NAMESPACE::FixedTag<float, 4>;

/// Calls four(i) for i = 0 and 4, each a mask of four lanes. @return eight bits.
template <class Four>
unsigned eight_bits(const Four& four) {
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; i += 4) {
        std::uint8_t bits = 0;
        hwy::HWY_NAMESPACE::StoreMaskBits(FourFloats(), four(i), &bits);
        mask |= static_cast<unsigned>(bits) << i;
    }
    return mask;
}

/// Boxes of eight children, one array a coordinate.
struct alignas(64) BoxNode {
    static constexpr std::size_t kWidth = 8;
    std::array<std::array<float, kWidth>, 3> low;
    std::array<std::array<float, kWidth>, 3> high;

    /// Bit i is set if p is in the box of child i.
    unsigned touched_by(const Vec3& p) const { return touched_by(Box{p, p}); }
    /// Bit i is set if the box has a point in common with that of child i.
    unsigned touched_by(const Box& box) const {
        namespace hn = hwy::HWY_NAMESPACE;
        constexpr FourFloats kFour;
        return eight_bits([&](unsigned i) {
            const auto overlap = [&](std::size_t axis) {
                const int c = static_cast<int>(axis);
                return hn::And(hn::Le(hn::Load(kFour, &low[axis][i]), hn::Set(kFour, box.high[c])),
                               hn::Le(hn::Set(kFour, box.low[c]), hn::Load(kFour, &high[axis][i])));
            };
            return hn::And(overlap(0), hn::And(overlap(1), overlap(2)));
        });
    }
};

class BoxTree {
public:
    BoxTree() = default;
    /// @param leaves  their boxes, neighbours in space near each other in the list.
    explicit BoxTree(std::vector<Box> leaves);

    /// Calls go_on(leaf) for leaves whose boxes the query (a Vec3 or a Box) touches, always in the
    /// same order, until it says false. @return whether it did.
    template <class Query, class GoOn>
    bool visit(const Query& query, const GoOn& go_on) const {
        return !levels_.empty() && descend(query, 0, go_on);
    }

    /// Appends the lowest nodes whose boxes the query touches, always in the same order: node j is
    /// over leaves 8 j .. 8 j + 7, and touched(j, box) asks for each of them.
    template <class Query>
    void append_nodes(const Query& query, std::vector<std::uint32_t>& nodes) const {
        if (levels_.size() == 1) nodes.push_back(0);
        if (levels_.size() < 2) return;
        descend(query, 1, [&](std::uint32_t node) {
            nodes.push_back(node);
            return true;
        });
    }
    template <class Query>
    unsigned touched(std::uint32_t node, const Query& query) const {
        return levels_[0][node].touched_by(query);
    }

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

    /// visit(), for what the nodes of level `last` stand over.
    template <class Query, class GoOn>
    bool descend(const Query& query, std::uint32_t last, const GoOn& go_on) const {
        std::array<Entry, 96> stack;  // 7 a level and 8: enough for 2^32 leaves
        std::size_t top = 0;
        stack[top++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
        while (top > 0) {
            const Entry at = stack[--top];
            unsigned mask = levels_[at.level][at.node].touched_by(query);
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

}  // namespace sunfleck
