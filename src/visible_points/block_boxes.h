// Boxes around blocks of discs, and what answers "which blocks?" fast.
#pragma once

#include "visible_points/box_tree.h"
#include "visible_points/occupancy.h"

#include <utility>
#include <vector>

namespace sunfleck::engine {

struct BlockBoxes {
    BlockBoxes() = default;
    explicit BlockBoxes(std::vector<Box> of_blocks)
        : boxes(std::move(of_blocks)), tree(boxes), occupancy(boxes) {}

    std::size_t bytes() const {
        return boxes.size() * sizeof(Box) + tree.bytes() + occupancy.bytes();
    }

    std::vector<Box> boxes;
    BoxTree tree;
    Occupancy occupancy;
};

}  // namespace sunfleck::engine
