// Nodes of the tree: what lies outside of the grid's box is not looked at.
#include "import/nvdb/tree.h"

#include "import/nvdb/file.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace sunfleck::engine {
namespace {

constexpr int kSide = VoxelBlocks::kCells;  // of a leaf
constexpr std::uint64_t kMostBlocks = std::uint64_t{1} << 25U;
/// Coordinates of points: beyond, doubles would still be exact, but blocks could not be counted.
constexpr std::int32_t kFarthest = 1 << 30;

// Where the numbers of a grid of floats are, in bytes.
constexpr std::uint64_t kGridSize = 32;
constexpr std::uint64_t kGridMap = 296 + 88;  // a matrix of doubles; its translation 144 behind
constexpr std::uint64_t kGridType = 636;
constexpr std::uint64_t kTree = 672;
constexpr std::uint64_t kRootOffset = kTree + 24;
constexpr std::uint64_t kRootTableSize = 24;
constexpr std::uint64_t kRootBackground = 28;
constexpr std::uint64_t kRootTiles = 64;
constexpr std::uint64_t kRootTile = 32;
constexpr std::uint64_t kLeafValues = 96;
constexpr std::uint64_t kLeafSize = kLeafValues + 512 * 4;

/// A kind of inner node.
struct NodeKind {
    int children;           // along each axis
    std::int64_t child;     // points of a child along each axis
    std::uint64_t mask;     // where the bits are that tell which children are nodes
    std::uint64_t entries;  // where the children or their values are, 8 bytes each
};
constexpr NodeKind kNodes[] = {{16, kSide, 544, 1088}, {32, 16 * kSide, 4128, 8256}};
constexpr std::int64_t kRootChild = std::int64_t{32} * 16 * kSide;

/// Returns the coordinate of a root's child by 21 bits of its key, with a sign.
std::int64_t root_coordinate(std::uint64_t key, unsigned shift) {
    const auto bits = static_cast<std::uint32_t>(key >> shift & 0xFFFFFU);
    return static_cast<std::int32_t>(bits << 12U);
}

std::int64_t floor_to(std::int64_t i, std::int64_t step) {
    return (i >= 0 ? i : i - step + 1) / step * step;
}

}  // namespace

NvdbTree::NvdbTree(const NvdbBytes& grid) : grid_(grid) {
    const std::string_view magic = grid.part(0, 8);
    if (magic != "NanoVDB0" && magic != "NanoVDB1")
        grid.refuse("has a grid without the mark of one", "write it again");
    check_nvdb_version(grid.at<std::uint32_t>(16), grid.name());
    if (grid.at<std::uint64_t>(kGridSize) != grid.size() || grid.at<std::uint32_t>(kGridType) != 1)
        grid.refuse("has a grid that is not what the file's head says", "write it again");
    read_map();
    const std::uint64_t root = kTree + grid.at<std::uint64_t>(kRootOffset);
    read_box(root);
    read_root(root);
}

void NvdbTree::read_map() {
    std::array<double, 12> m{};
    for (std::size_t i = 0; i < m.size(); ++i)
        m.at(i) = grid_.at<double>(kGridMap + 8 * (i < 9 ? i : i + 9));
    to_world_.x = {m[0], m[3], m[6]};
    to_world_.y = {m[1], m[4], m[7]};
    to_world_.z = {m[2], m[5], m[8]};
    to_world_.origin = {m[9], m[10], m[11]};
    if (!to_world_.is_invertible())
        grid_.refuse("has a grid whose voxels have no size", "write it again");
}

void NvdbTree::read_box(std::uint64_t root) {
    std::uint64_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto min = grid_.at<std::int32_t>(root + 4 * axis);
        const auto max = grid_.at<std::int32_t>(root + 12 + 4 * axis);
        if (min > max) grid_.refuse("has a grid without a voxel", "name another grid");
        if (min < -kFarthest || max > kFarthest)
            grid_.refuse("has voxels beyond 2^30 of its origin", "cut it to what is seen");
        low_[axis] = static_cast<int>(floor_to(min, kSide));
        box_low_[axis] = min - low_[axis];
        box_high_[axis] = max + 1 - low_[axis];
        blocks_[axis] = box_high_[axis] / kSide + 1;
        if (static_cast<std::uint64_t>(blocks_[axis]) > kMostBlocks / count)
            grid_.refuse("spans more than 2^25 blocks of 8^3 voxels", "cut it to what is seen");
        count *= static_cast<std::uint64_t>(blocks_[axis]);
    }
    const float background = checked(grid_.at<float>(root + kRootBackground));
    entries_.assign(count, {0, background});
}

/// Each child once, so that a small file cannot ask for much work.
void NvdbTree::read_root(std::uint64_t root) {
    const auto count = grid_.at<std::uint32_t>(root + kRootTableSize);
    grid_.part(root + kRootTiles, count * kRootTile);
    std::set<std::uint64_t> known;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t tile = root + kRootTiles + i * kRootTile;
        const auto key = grid_.at<std::uint64_t>(tile);
        if (!known.insert(key).second) grid_.refuse("has two nodes in one place", "write it again");
        Box box{{root_coordinate(key, 42), root_coordinate(key, 21), root_coordinate(key, 0)}, {}};
        for (std::size_t axis = 0; axis < 3; ++axis) box.high[axis] = box.low[axis] + kRootChild;
        const auto child = grid_.at<std::uint64_t>(tile + 8);
        if (child == 0)
            fill(box, grid_.at<float>(tile + 20));
        else
            read_node(child_of(root, child), box, 1);
    }
}

/// Returns where a child begins: behind its parent. Thus no node has itself below it.
std::uint64_t NvdbTree::child_of(std::uint64_t parent, std::uint64_t offset) const {
    if (offset == 0 || offset > grid_.size())
        grid_.refuse("has a node that leads out of it", "write it again");
    return parent + offset;
}

/// @param box  of the node. @param level  index into kNodes; below it are leaves.
void NvdbTree::read_node(std::uint64_t node, const Box& box, int level) {
    if (level < 0) return read_leaf(node, box);
    const NodeKind& kind = kNodes[level];
    const auto count = static_cast<std::uint64_t>(kind.children);
    grid_.part(node, kind.entries + 8 * count * count * count);
    const Box seen = within(box);
    const auto first = [&](std::size_t axis) {
        return (seen.low[axis] - box.low[axis]) / kind.child;
    };
    const auto at = [&](std::size_t axis, std::int64_t i) {
        return box.low[axis] + i * kind.child;
    };
    for (std::int64_t x = first(0); at(0, x) < seen.high[0]; ++x)
        for (std::int64_t y = first(1); at(1, y) < seen.high[1]; ++y)
            for (std::int64_t z = first(2); at(2, z) < seen.high[2]; ++z) {
                const Box child{{at(0, x), at(1, y), at(2, z)},
                                {at(0, x + 1), at(1, y + 1), at(2, z + 1)}};
                const auto i =
                    static_cast<std::uint64_t>((x * kind.children + y) * kind.children + z);
                const std::uint64_t entry = node + kind.entries + 8 * i;
                const auto mask = grid_.at<std::uint32_t>(node + kind.mask + i / 32 * 4);
                if ((mask >> (i % 32U) & 1U) != 0)
                    read_node(child_of(node, grid_.at<std::uint64_t>(entry)), child, level - 1);
                else
                    fill(child, grid_.at<float>(entry));
            }
}

void NvdbTree::read_leaf(std::uint64_t leaf, const Box& box) {
    grid_.part(leaf, kLeafSize);
    for (std::uint64_t i = 0; i < 512; ++i) checked(grid_.at<float>(leaf + kLeafValues + 4 * i));
    leaves_.push_back(leaf + kLeafValues);
    // A small file must not ask for much: leaves share no bytes.
    if (leaves_.size() > grid_.size() / kLeafSize)
        grid_.refuse("has two leaves in one place", "write it again");
    Voxel block{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        block[axis] = static_cast<int>((box.low[axis] - low_[axis]) / kSide);
    entries_[number_of(block)] = {static_cast<std::uint32_t>(leaves_.size()), 0};
}

void NvdbTree::fill(const Box& box, float value) {
    const Box seen = within(box);
    const auto first = [&](std::size_t axis) {
        return static_cast<int>((seen.low[axis] - low_[axis]) / kSide);
    };
    const auto end = [&](std::size_t axis) {
        return static_cast<int>((seen.high[axis] - low_[axis]) / kSide);
    };
    for (int z = first(2); z < end(2); ++z)
        for (int y = first(1); y < end(1); ++y)
            for (int x = first(0); x < end(0); ++x)
                entries_[number_of({x, y, z})] = {0, checked(value)};
}

float NvdbTree::checked(float value) const {
    if (!(value >= 0 && std::isfinite(value)))
        grid_.refuse("has a value that is negative or no finite number", "mend the grid");
    return value;
}

/// Returns the part that is known: of whole blocks, and nothing if high is not above low.
NvdbTree::Box NvdbTree::within(const Box& box) const {
    Box part = box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        part.low[axis] = std::max<std::int64_t>(box.low[axis], low_[axis]);
        part.high[axis] = std::min<std::int64_t>(box.high[axis],
                                                 low_[axis] + std::int64_t{blocks_[axis]} * kSide);
    }
    return part;
}

std::size_t NvdbTree::number_of(const Voxel& block) const {
    const auto size = [](int i) { return static_cast<std::size_t>(i); };
    return size(block[0]) + size(blocks_[0]) * (size(block[1]) + size(blocks_[1]) * size(block[2]));
}

float NvdbTree::value(const Voxel& point) const {
    const Entry& entry =
        entries_[number_of({point[0] / kSide, point[1] / kSide, point[2] / kSide})];
    if (entry.leaf == 0) return entry.value;
    const int place = (point[0] % kSide * kSide + point[1] % kSide) * kSide + point[2] % kSide;
    return grid_.at<float>(leaves_[entry.leaf - 1] + 4 * static_cast<std::uint64_t>(place));
}

std::optional<float> NvdbTree::constant(const Voxel& low, const Voxel& high) const {
    const auto block = [](const Voxel& p) {
        return Voxel{p[0] / kSide, p[1] / kSide, p[2] / kSide};
    };
    const Voxel first = block(low);
    const Voxel last = block(high);
    const Entry& one = entries_[number_of(first)];
    for (int z = first[2]; z <= last[2]; ++z)
        for (int y = first[1]; y <= last[1]; ++y)
            for (int x = first[0]; x <= last[0]; ++x) {
                const Entry& other = entries_[number_of({x, y, z})];
                if (other.leaf != 0 || other.value != one.value) return {};
            }
    return one.value;
}

}  // namespace sunfleck::engine
