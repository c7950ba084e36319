// Fills the cells.
#include "visible_points/occupancy.h"

#include "core/parallel.h"

#include <atomic>

namespace sunfleck::engine {

Occupancy::Occupancy(const std::vector<Box>& boxes) : rows_(kCells * kCells, 0) {
    constexpr std::size_t kBlock = 4096;
    for (const Box& box : boxes) bounds_.extend(box);
    const Vec3 size = bounds_.high - bounds_.low;
    cells_per_unit_ = static_cast<float>(kCells) / std::max({size.x, size.y, size.z, 1e-30F});
    parallel_blocks(boxes.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) mark(boxes[i]);
    });
}

void Occupancy::mark(const Box& box) {
    const std::size_t first = cell(box.low, 0);
    const std::size_t width = cell(box.high, 0) - first;
    const std::uint64_t cells = (~std::uint64_t{0} >> (kCells - 1 - width)) << first;
    for (std::size_t z = cell(box.low, 2); z <= cell(box.high, 2); ++z)
        for (std::size_t y = cell(box.low, 1); y <= cell(box.high, 1); ++y) {
            std::atomic_ref<std::uint64_t> marked(rows_[row(y, z)]);
            if ((cells & ~marked.load(std::memory_order_relaxed)) != 0)
                marked.fetch_or(cells, std::memory_order_relaxed);
        }
}

}  // namespace sunfleck::engine
