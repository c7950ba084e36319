// Variances of trial passes whose noise is known.
#include "render/trial_variance.h"

#include "core/random.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

constexpr int kSize = 64;
constexpr std::size_t kPixels = std::size_t{kSize} * kSize;

/// Pairs of trials of brightness `mean`, with uniform noise of the variances given: of the view,
/// and of each set of photons.
std::array<TrialPair, 2> trials(double mean, double eye, double photon) {
    const auto noise = [](RandomStream& random, double variance) {
        return (2 * random.next() - 1) * std::sqrt(3 * variance);
    };
    std::array<TrialPair, 2> both;
    for (std::size_t view = 0; view < 2; ++view)
        for (TrialPixels& set : both.at(view)) set.resize(kPixels);
    for (std::size_t i = 0; i < kPixels; ++i) {
        RandomStream random(5, Purpose::test, 0, static_cast<std::uint32_t>(i));
        for (TrialPair& view : both) {
            const double shared = mean + noise(random, eye);
            for (TrialPixels& set : view) set[i] = shared + noise(random, photon);
        }
    }
    return both;
}

BlockVariance mean_of(const std::vector<BlockVariance>& blocks) {
    BlockVariance mean;
    for (const BlockVariance& b : blocks) {
        mean.eye += b.eye / static_cast<double>(blocks.size());
        mean.photon += b.photon / static_cast<double>(blocks.size());
    }
    return mean;
}

// 4096 pixels: standard errors of some 2% of either variance.
TEST(TrialVariance, parts_camera_paths_from_photons) {
    const BlockGrid grid(kSize, kSize, 16);
    for (const double eye : {0.0, 0.02, 0.2})
        for (const double photon : {0.0, 0.02, 0.2}) {
            const auto both = trials(2, eye, photon);
            const auto blocks = block_variances(grid, both[0], both[1], 1000);
            ASSERT_EQ(blocks.size(), 16U);
            const BlockVariance mean = mean_of(blocks);
            EXPECT_NEAR(mean.eye, eye / 4, 0.06 * (eye + photon) / 4 + 1e-12);
            EXPECT_NEAR(mean.photon / 1000, photon / 4, 0.06 * photon / 4 + 1e-12);
        }
}

TEST(TrialVariance, is_relative_and_leaves_dark_blocks_out) {
    const BlockGrid grid(kSize, kSize, 16);
    auto both = trials(2, 0.2, 0.1);
    const BlockVariance before = mean_of(block_variances(grid, both[0], both[1], 1));
    for (TrialPair& view : both)
        for (TrialPixels& set : view)
            for (double& x : set) x *= 1e-3;
    const BlockVariance after = mean_of(block_variances(grid, both[0], both[1], 1));
    EXPECT_NEAR(after.eye, before.eye, 1e-9);
    EXPECT_NEAR(after.photon, before.photon, 1e-9);
    for (TrialPair& view : both)
        for (TrialPixels& set : view) grid.for_pixels(3, [&](std::size_t i) { set[i] *= 1e-3; });
    EXPECT_EQ(block_variances(grid, both[0], both[1], 1).size(), 15U);
    for (TrialPair& view : both)
        for (TrialPixels& set : view) set.assign(kPixels, 0);
    EXPECT_TRUE(block_variances(grid, both[0], both[1], 1).empty());
}

TEST(TrialVariance, says_how_bright_a_block_is) {
    const BlockGrid grid(kSize, kSize, 16);
    const auto both = trials(2, 0, 0);
    for (const BlockVariance& block : block_variances(grid, both[0], both[1], 1))
        EXPECT_NEAR(block.brightness, 2, 1e-12);
}

TEST(TrialVariance, is_also_that_of_a_thinned_picture) {
    const PixelWindow window{3, 5, 8, 8};  // 5 columns, 3 rows
    TrialPixels pixels(15);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<double>(i);
    EXPECT_EQ(thinned(pixels, window, 2), (TrialPixels{0, 2, 4, 10, 12, 14}));
    EXPECT_EQ(thinned(pixels, window, 1), pixels);
    EXPECT_EQ(one_of(5, 2), 3);
    EXPECT_EQ(one_of(4, 2), 2);
}

}  // namespace
}  // namespace sunfleck
