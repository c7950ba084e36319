// Sums and scales by block.
#include "planning/judged_blocks.h"

namespace sunfleck::engine {

BlockGrid judged_blocks(const PixelWindow& window, int cells) {
    return {window.width(), window.height(), static_cast<std::size_t>(8 * cells)};
}

std::vector<double> block_sums(const BlockGrid& blocks, const PixelValues& values) {
    std::vector<double> sums(blocks.count());
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
        sums[blocks.block_of(pixel)] += values[pixel];
    return sums;
}

std::vector<double> squared_scales(const BlockGrid& blocks, const std::vector<double>& light,
                                   Objective objective) {
    const auto pixels_of = [&](std::size_t b) {
        return static_cast<double>(blocks.block(b).pixels());
    };
    double all = 0;
    double pixels = 0;
    for (std::size_t b = 0; b < light.size(); ++b) {
        all += light[b];
        pixels += pixels_of(b);
    }
    std::vector<double> scales;
    for (std::size_t b = 0; b < light.size(); ++b)
        scales.push_back(squared_scale(objective, light[b] / pixels_of(b), all / pixels));
    return scales;
}

PixelValues squared_scales(const PixelWindow& window, const PixelValues& light,
                           Objective objective) {
    const BlockGrid blocks = judged_blocks(window);
    const std::vector<double> of_blocks =
        squared_scales(blocks, block_sums(blocks, light), objective);
    PixelValues scales(light.size());
    for (std::size_t pixel = 0; pixel < scales.size(); ++pixel)
        scales[pixel] = of_blocks[blocks.block_of(pixel)];
    return scales;
}

}  // namespace sunfleck::engine
