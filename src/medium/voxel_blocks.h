// VoxelBlocks: a value at each integer point of a box, in blocks of cells.
//
// In:  a source that tells the value of a point. Out: the values of a block, those at the corners
// of each of its cells among them. A block has 8^3 cells and the 9^3 points around them:
// neighbouring blocks both hold the points between them, so that a cell is read from one block. A
// block whose values are all the same is one number.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// A point, a cell (by its lowest corner) or a block, along x, y and z.
using Voxel = std::array<int, 3>;

/// value() returns the value of a point: finite, 0 or more. constant() returns the value of all
/// points of a box, low and high included, if the source knows without looking at each.
template <class Source>
concept VoxelSource = requires(const Source& source, const Voxel& point) {
    { source.value(point) } -> std::same_as<float>;
    { source.constant(point, point) } -> std::same_as<std::optional<float>>;
};

class VoxelBlocks {
public:
    static constexpr int kCells = 8;            // of a block, along an axis
    static constexpr int kPoints = kCells + 1;  // the same

    /// @param cells  along each axis, 1 or more. There is one more point along it.
    template <VoxelSource Source>
    VoxelBlocks(const Voxel& cells, const Source& source);

    const Voxel& cells() const { return cells_; }
    const Voxel& blocks() const { return blocks_; }
    float greatest() const { return greatest_; }

    struct Block {
        const float* values = nullptr;  // of 9^3 points, x first; null where all are `constant`
        float constant = 0;
    };
    /// @param at  below blocks().
    Block block(const Voxel& at) const {
        const std::uint32_t entry = table_[number_of(at)];
        if ((entry & kHasValues) == 0) return {nullptr, std::bit_cast<float>(entry)};
        return {values_.data() + kValues * (entry - kHasValues), 0};
    }
    /// @param point  at most cells().
    float value(const Voxel& point) const {
        const auto block_of = [&](std::size_t axis) {
            return std::min(point[axis] / kCells, blocks_[axis] - 1);
        };
        const Voxel at = {block_of(0), block_of(1), block_of(2)};
        const Block found = block(at);
        if (!found.values) return found.constant;
        return found.values[place(point[0] - at[0] * kCells, point[1] - at[1] * kCells,
                                  point[2] - at[2] * kCells)];
    }
    /// Returns the place of a point in the values of its block.
    static constexpr int place(int x, int y, int z) { return x + kPoints * (y + kPoints * z); }

private:
    static constexpr std::size_t kValues = kPoints * kPoints * kPoints;
    /// An entry of the table is a number of values, or a float: its sign is free.
    static constexpr std::uint32_t kHasValues = 0x80000000;

    static int blocks_for(int cells) { return (cells + kCells - 1) / kCells; }
    std::size_t number_of(const Voxel& at) const {
        const auto size = [](int i) { return static_cast<std::size_t>(i); };
        return size(at[0]) + size(blocks_[0]) * (size(at[1]) + size(blocks_[1]) * size(at[2]));
    }
    template <VoxelSource Source>
    void add_block(const Voxel& at, const Source& source);
    void add(const std::array<float, kValues>& values);
    void add(float constant);

    Voxel cells_;
    Voxel blocks_;
    std::vector<std::uint32_t> table_;
    std::vector<float> values_;
    float greatest_ = 0;
};

template <VoxelSource Source>
VoxelBlocks::VoxelBlocks(const Voxel& cells, const Source& source)
    : cells_(cells), blocks_{blocks_for(cells[0]), blocks_for(cells[1]), blocks_for(cells[2])} {
    for (int z = 0; z < blocks_[2]; ++z)
        for (int y = 0; y < blocks_[1]; ++y)
            for (int x = 0; x < blocks_[0]; ++x) add_block({x, y, z}, source);
}

/// Points beyond the last one have its value: no cell of the box has them as corners.
template <VoxelSource Source>
void VoxelBlocks::add_block(const Voxel& at, const Source& source) {
    Voxel low{};
    Voxel high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = at[axis] * kCells;
        high[axis] = low[axis] + kCells < cells_[axis] ? low[axis] + kCells : cells_[axis];
    }
    if (const std::optional<float> constant = source.constant(low, high)) return add(*constant);
    std::array<float, kValues> values;
    std::size_t next = 0;
    const auto point = [&](std::size_t axis, int i) {
        return low[axis] + i < high[axis] ? low[axis] + i : high[axis];
    };
    for (int z = 0; z < kPoints; ++z)
        for (int y = 0; y < kPoints; ++y)
            for (int x = 0; x < kPoints; ++x)
                values[next++] = source.value({point(0, x), point(1, y), point(2, z)});
    add(values);
}

}  // namespace sunfleck::engine
