// All pixels of a pass, in blocks.
#include "eye/eye_pass.h"

#include "core/parallel.h"
#include "eye/eye_path.h"

namespace sunfleck {

VisiblePointLists trace_eye_paths(const EyePass& pass, PassImage& image, Statistics& statistics) {
    constexpr std::size_t kBlock = 256;
    const std::size_t pixels = pass.window.pixels();
    const FilterSampler filter(pass.scene.scene.filter());
    VisiblePointLists lists((pixels + kBlock - 1) / kBlock);
    std::vector<Statistics> counts(lists.size());
    parallel_blocks(pixels, kBlock, [&](std::size_t begin, std::size_t end) {
        const std::size_t block = begin / kBlock;
        lists[block].reserve(end - begin);
        for (std::size_t pixel = begin; pixel < end; ++pixel)
            EyePath(pass, filter, image, lists[block], counts[block])
                .trace(static_cast<std::uint32_t>(pixel));
        counts[block][Count::visible_points] += lists[block].size();
    });
    for (const Statistics& c : counts) statistics += c;
    return lists;
}

}  // namespace sunfleck
