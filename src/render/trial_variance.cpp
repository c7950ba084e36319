// Sums over blocks of products of differences.
#include "render/trial_variance.h"

namespace sunfleck {
namespace {

constexpr double kDark = 0.01;  // of the picture's brightness

/// Means over the pixels of a block.
struct BlockMeans {
    double light = 0;  // of all four
    double eye = 0;
    double photon = 0;
};

BlockMeans means_of(const BlockGrid& grid, std::size_t block, const TrialPair& one,
                    const TrialPair& other) {
    BlockMeans sums;
    grid.for_pixels(block, [&](std::size_t i) {
        const double a = one[0][i];
        const double b = one[1][i];
        const double c = other[0][i];
        const double d = other[1][i];
        sums.light += (a + b + c + d) / 4;
        sums.eye += (a - c) * (b - d) / 2;
        sums.photon += ((a - b) * (a - b) + (c - d) * (c - d)) / 4;
    });
    const auto pixels = static_cast<double>(grid.block(block).pixels());
    return {sums.light / pixels, sums.eye / pixels, sums.photon / pixels};
}

}  // namespace

TrialPixels luminance_of(const PassImage& image) {
    TrialPixels pixels;
    pixels.reserve(image.pixels());
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const RgbSum sum{{image.value(Layer::total, i, 0), image.value(Layer::total, i, 1),
                          image.value(Layer::total, i, 2)}};
        pixels.push_back(sum.mean_luminance(1));
    }
    return pixels;
}

TrialPixels thinned(const TrialPixels& pixels, const PixelWindow& window, int every) {
    TrialPixels few;
    for (int y = 0; y < window.height(); y += every)
        for (int x = 0; x < window.width(); x += every)
            few.push_back(pixels[static_cast<std::size_t>(y * window.width() + x)]);
    return few;
}

std::vector<BlockVariance> block_variances(const BlockGrid& grid, const TrialPair& one,
                                           const TrialPair& other, double paths) {
    std::vector<BlockMeans> blocks;
    double light = 0;
    for (std::size_t b = 0; b < grid.count(); ++b) {
        blocks.push_back(means_of(grid, b, one, other));
        light += blocks.back().light * static_cast<double>(grid.block(b).pixels());
    }
    const double floor = kDark * light / static_cast<double>(one[0].size());
    std::vector<BlockVariance> variances;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const BlockMeans& block = blocks[b];
        if (block.light <= floor) continue;
        const double square = block.light * block.light;
        variances.push_back({block.eye / square, block.photon / square * paths, b, block.light});
    }
    return variances;
}

}  // namespace sunfleck
