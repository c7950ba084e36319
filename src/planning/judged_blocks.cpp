// Sums and scales by block.
#include "planning/judged_blocks.h"

namespace sunfleck::engine {

BlockGrid judged_blocks(const PixelWindow& window) {
    return {window.width(), window.height(), 8};
}

std::vector<double> block_sums(const BlockGrid& blocks, const PixelValues& values) {
    std::vector<double> sums(blocks.count());
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
        sums[blocks.block_of(pixel)] += values[pixel];
    return sums;
}

PixelValues squared_scales(const PixelWindow& window, const PixelValues& light,
                           Objective objective) {
    const double mean = mean_value(light);
    const BlockGrid blocks = judged_blocks(window);
    const std::vector<double> sums = block_sums(blocks, light);
    PixelValues scales(light.size());
    for (std::size_t b = 0; b < sums.size(); ++b) {
        const double brightness = sums[b] / static_cast<double>(blocks.block(b).pixels());
        const double scale = squared_scale(objective, brightness, mean);
        blocks.for_pixels(b, [&](std::size_t pixel) { scales[pixel] = scale; });
    }
    return scales;
}

}  // namespace sunfleck::engine
