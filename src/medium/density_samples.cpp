// Samples as the points of a lattice.
#include "medium/density_samples.h"

namespace sunfleck::engine {
namespace {

/// Values at points from `first` on, and zeros around them.
struct Samples {
    std::span<const float> values;
    Voxel count;
    int first;

    float value(const Voxel& point) const {
        std::size_t place = 0;
        for (const std::size_t axis : {2U, 1U, 0U}) {
            const int i = point[axis] - first;
            if (i < 0 || i >= count[axis]) return 0;
            place = place * static_cast<std::size_t>(count[axis]) + static_cast<std::size_t>(i);
        }
        return values[place];
    }
    static std::optional<float> constant(const Voxel&, const Voxel&) { return {}; }
};

/// Returns the map from a lattice to the world. @param border  the lattice's point where the box
/// begins, along each axis.
Affine from_lattice(const Affine& box_to_world, const Voxel& parts, double border) {
    Affine map = box_to_world;
    map.x = map.x / parts[0];
    map.y = map.y / parts[1];
    map.z = map.z / parts[2];
    map.origin = map.point(Vec3d(-border));
    return map;
}

}  // namespace

DensityGrid density_of_parts(std::span<const float> values, const Voxel& parts,
                             const Affine& box_to_world) {
    const Voxel cells = {parts[0] + 1, parts[1] + 1, parts[2] + 1};
    const Bounds bounds{Vec3d(0.5), {parts[0] + 0.5, parts[1] + 0.5, parts[2] + 0.5}};
    auto voxels = std::make_shared<const VoxelBlocks>(cells, Samples{values, parts, 1});
    return {std::move(voxels), bounds, from_lattice(box_to_world, parts, 0.5)};
}

DensityGrid density_of_points(std::span<const float> values, const Voxel& parts,
                              const Affine& box_to_world) {
    const Voxel points = {parts[0] + 1, parts[1] + 1, parts[2] + 1};
    const Vec3d size(parts[0], parts[1], parts[2]);
    auto voxels = std::make_shared<const VoxelBlocks>(parts, Samples{values, points, 0});
    return {std::move(voxels), {Vec3d(0), size}, from_lattice(box_to_world, parts, 0)};
}

}  // namespace sunfleck::engine
