// Sums over blocks of products of differences.
#include "planning/trial_variance.h"

#include "core/parallel.h"

namespace sunfleck::engine {
namespace {

/// Sums over the pixels of a block that both trials have.
struct BlockSums {
    double light = 0;
    double camera = 0;
    double photon = 0;
    double pixels = 0;
};

/// Factors of a pixel's variances under an allocation.
struct Left {
    double camera = 1;
    double photon = 1;  // of the part that trials do not share
    double unlit = 1;   // subtracted from camera paths, which pixel trials measure better
};

void add_pixel(const TrialPair& pair, std::size_t i, const Left& left, BlockSums& sums) {
    const double a = pair.one.lit[0][i];
    const double b = pair.one.lit[1][i];
    const double c = pair.other.lit[0][i];
    const double d = pair.other.lit[1][i];
    const double unlit = pair.one.camera[i] - pair.other.camera[i];
    const double shared = (a - b) * (c - d) / 2;
    const double all = ((a - b) * (a - b) + (c - d) * (c - d)) / 4;
    sums.light += (a + b + c + d) / 4;
    sums.camera += ((a - c) * (b - d) - left.unlit * unlit * unlit) / 2 * left.camera;
    sums.photon += shared + (all - shared) * left.photon;
    ++sums.pixels;
}

BlockSums sums_of(const PixelCells& cells, std::size_t block, const TrialPair& pair,
                  const PixelTrials& trials, const CameraShares& shares) {
    BlockSums sums;
    const BlockGrid grid(cells.window.width(), cells.window.height(), kTrialBlock);
    grid.for_pixels(block, [&](std::size_t i) {
        if (!cells.has(i)) return;
        const unsigned log2_samples = shares.log2_samples_of(i);
        const Left left{trials.nets[block].left(log2_samples), 1.0 / (1U << log2_samples),
                        trials.are_made() ? 1.0 : 0.0};
        add_pixel(pair, i, left, sums);
    });
    if (trials.are_made())
        sums.camera += sums.pixels * remaining_variance(shares, trials, grid, block);
    return sums;
}

}  // namespace

std::vector<BlockVariance> block_variances(const PixelWindow& window, const TrialPair& pair,
                                           const PixelTrials& trials, const CameraShares& shares,
                                           Objective objective) {
    const BlockGrid grid(window.width(), window.height(), kTrialBlock);
    std::vector<BlockSums> blocks(grid.count());
    parallel_for(grid.count(), [&](std::size_t b) {
        blocks[b] = sums_of({window, pair.cells}, b, pair, trials, shares);
    });
    double light = 0;
    double pixels = 0;
    for (const BlockSums& block : blocks) {
        light += block.light;
        pixels += block.pixels;
    }
    const double mean = light / pixels;
    if (!(mean > 0)) return {};
    std::vector<BlockVariance> variances;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const BlockSums& sums = blocks[b];
        const double squares =
            sums.pixels * squared_scale(objective, sums.light / sums.pixels, mean);
        variances.push_back({trials.nets[b].of_batch() * sums.camera / squares,
                             sums.photon / squares * pair.paths});
    }
    return variances;
}

}  // namespace sunfleck::engine
