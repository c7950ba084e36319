// Builds the tree, level by level.
#include "visible_points/box_tree.h"

#include "core/parallel.h"

namespace sunfleck::engine {
namespace {

/// The node over boxes first .. first + 7 (those that exist); an empty box is touched by nothing.
BoxNode node_over(const std::vector<Box>& boxes, std::size_t first, Box& all) {
    BoxNode node;
    for (std::size_t i = 0; i < BoxNode::kWidth; ++i) {
        const Box box = first + i < boxes.size() ? boxes[first + i] : Box{};
        for (int c = 0; c < 3; ++c) {
            const auto axis = static_cast<std::size_t>(c);
            node.low.at(axis).at(i) = box.low[c];
            node.high.at(axis).at(i) = box.high[c];
        }
        all.extend(box);
    }
    return node;
}

}  // namespace

BoxTree::BoxTree(std::vector<Box> leaves) {
    constexpr std::size_t kBlock = 512;
    std::vector<Box> boxes = std::move(leaves);
    if (boxes.empty()) return;
    do {
        const std::size_t count = (boxes.size() + kWidth - 1) / kWidth;
        std::vector<BoxNode> level(count);
        std::vector<Box> parents(count);
        parallel_blocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                level[i] = node_over(boxes, i * kWidth, parents[i]);
        });
        levels_.push_back(std::move(level));
        boxes = std::move(parents);
    } while (boxes.size() > 1);
}

}  // namespace sunfleck::engine
