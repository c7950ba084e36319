// A tree's values as blocks.
#include "import/nvdb/density.h"

#include "core/printable.h"
#include "import/nvdb/file.h"
#include "import/nvdb/tree.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kFloat = 1;
constexpr std::uint32_t kUnknown = 0;
constexpr std::uint32_t kFogVolume = 2;

std::string names_of(const std::vector<NvdbGridHead>& grids) {
    std::string names;
    for (const NvdbGridHead& grid : grids)
        names += (names.empty() ? "" : ", ") + in_quotes(grid.name);
    return names;
}

NvdbGridHead find(std::string_view file, const std::string& grid, const std::string& name) {
    const std::vector<NvdbGridHead> grids = nvdb_grids(file, name);
    const auto found = std::find_if(grids.begin(), grids.end(),
                                    [&](const NvdbGridHead& head) { return head.name == grid; });
    if (found == grids.end())
        throw Error({name}, "has no grid " + in_quotes(grid),
                    "name one of its grids: " + printable(names_of(grids), 200));
    if (found->type != kFloat)
        throw Error({name}, "has a grid " + in_quotes(grid) + " that is not of floats",
                    "write it as a grid of floats");
    if (found->grid_class != kFogVolume && found->grid_class != kUnknown)
        throw Error({name}, "has a grid " + in_quotes(grid) + " that is no fog volume",
                    "name a grid of densities, or turn the level set into one");
    return *found;
}

/// Returns the map from points that count from the tree's low().
Affine map_of(const NvdbTree& tree, const Affine& to_world) {
    const Affine& own = tree.to_world();
    Affine map;
    map.x = to_world.vector(own.x);
    map.y = to_world.vector(own.y);
    map.z = to_world.vector(own.z);
    map.origin = to_world.point(own.point(Vec3d(tree.low()[0], tree.low()[1], tree.low()[2])));
    return map;
}

}  // namespace

bool has_nvdb_grid(std::string_view file, const std::string& grid, const std::string& name) {
    const std::vector<NvdbGridHead> grids = nvdb_grids(file, name);
    return std::any_of(grids.begin(), grids.end(),
                       [&](const NvdbGridHead& head) { return head.name == grid; });
}

DensityGrid nvdb_density(std::string_view file, const std::string& grid, const Matrix& to_world,
                         const std::string& name) {
    const std::string bytes = unpacked_grid(find(file, grid, name), name);
    const NvdbBytes numbers(bytes, name);
    const NvdbTree tree(numbers);
    const Affine map = map_of(tree, Affine(to_world));
    if (!map.is_invertible())
        throw Error({name}, "has a grid that is placed flat or beyond all numbers",
                    "give it another size");
    const auto vector = [](const Voxel& p) { return Vec3d(p[0], p[1], p[2]); };
    auto voxels = std::make_shared<const VoxelBlocks>(tree.box_high(), tree);
    return {std::move(voxels), {vector(tree.box_low()), vector(tree.box_high())}, map};
}

}  // namespace sunfleck::engine
