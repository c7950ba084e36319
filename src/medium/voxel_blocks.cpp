// Blocks of one value, and of many.
#include "medium/voxel_blocks.h"

#include <algorithm>

namespace sunfleck::engine {

void VoxelBlocks::add(float constant) {
    greatest_ = std::max(greatest_, constant);
    table_.push_back(std::bit_cast<std::uint32_t>(std::abs(constant)));
}

void VoxelBlocks::add(const std::array<float, kValues>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (*least == *most) return add(*most);
    greatest_ = std::max(greatest_, *most);
    table_.push_back(kHasValues + static_cast<std::uint32_t>(values_.size() / kValues));
    values_.insert(values_.end(), values.begin(), values.end());
}

}  // namespace sunfleck::engine
