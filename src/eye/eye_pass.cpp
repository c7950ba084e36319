// All pixels of a pass, in blocks.
#include "eye/eye_pass.h"

#include "core/parallel.h"
#include "eye/eye_path.h"

namespace sunfleck {

std::vector<VisiblePoint> trace_eye_paths(const EyePass& pass, PassImage& image,
                                          Statistics& statistics) {
    constexpr std::size_t kBlock = 256;
    const std::size_t pixels = pass.window.pixels();
    const FilterSampler filter(pass.scene.scene.filter());
    struct Block {
        std::vector<VisiblePoint> points;
        Statistics statistics;
    };
    std::vector<Block> blocks((pixels + kBlock - 1) / kBlock);
    parallel_blocks(pixels, kBlock, [&](std::size_t begin, std::size_t end) {
        Block& block = blocks[begin / kBlock];
        block.points.reserve(end - begin);
        for (std::size_t pixel = begin; pixel < end; ++pixel)
            EyePath(pass, filter, image, block.points, block.statistics)
                .trace(static_cast<std::uint32_t>(pixel));
    });
    std::vector<VisiblePoint> points;
    points.reserve(pixels);
    for (const Block& block : blocks) {
        points.insert(points.end(), block.points.begin(), block.points.end());
        statistics += block.statistics;
    }
    statistics[Count::visible_points] += points.size();
    return points;
}

}  // namespace sunfleck
