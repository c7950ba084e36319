// NvdbTree: the values of a float grid of NanoVDB, by blocks of 8^3 points.
//
// A root has upper nodes of 32^3 lower ones, these have 16^3 leaves, and these 8^3 values. In place
// of a node there may be one value for all its points.
// Source: OpenVDB's nanovdb/PNanoVDB.h (Mozilla Public License), for where the numbers are.
#pragma once

#include "geometry/affine.h"
#include "import/nvdb/bytes.h"
#include "medium/voxel_blocks.h"

#include <vector>

namespace sunfleck::engine {

class NvdbTree {
public:
    /// Reads the tree, and checks each offset and each value in the box.
    /// @param grid  its bytes, which must outlive this.
    /// @throws Error  for bytes that are no such grid, more than 2^25 blocks, and values that are
    /// negative or not finite.
    explicit NvdbTree(const NvdbBytes& grid);

    /// Returns the first point of the box whose points are known: of a block.
    const Voxel& low() const { return low_; }
    /// Returns the box where the grid has values, in points from low(): to one beyond the last
    /// (pbrt-v4).
    const Voxel& box_low() const { return box_low_; }
    const Voxel& box_high() const { return box_high_; }
    /// Returns the map from points of the grid, not from low(), to the grid's world.
    const Affine& to_world() const { return to_world_; }

    /// As VoxelSource asks, of points from low().
    float value(const Voxel& point) const;
    std::optional<float> constant(const Voxel& low, const Voxel& high) const;

private:
    /// Points of the grid: low included, high not.
    struct Box {
        std::array<std::int64_t, 3> low;
        std::array<std::int64_t, 3> high;
    };
    /// A block: a leaf, or one value.
    struct Entry {
        std::uint32_t leaf = 0;  // number in leaves_, from 1; 0 for none
        float value = 0;
    };

    void read_map();
    void read_box(std::uint64_t root);
    void read_root(std::uint64_t root);
    std::uint64_t child_of(std::uint64_t parent, std::uint64_t offset) const;
    void read_node(std::uint64_t node, const Box& box, int level);
    void read_leaf(std::uint64_t leaf, const Box& box);
    void fill(const Box& box, float value);
    float checked(float value) const;
    Box within(const Box& box) const;
    std::size_t number_of(const Voxel& block) const;

    const NvdbBytes& grid_;
    Affine to_world_;
    Voxel low_{};
    Voxel box_low_{};
    Voxel box_high_{};
    Voxel blocks_{};
    std::vector<Entry> entries_;
    std::vector<std::uint64_t> leaves_;  // where their values begin
};

}  // namespace sunfleck::engine
