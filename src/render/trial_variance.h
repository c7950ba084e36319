// Variances of camera paths and of photon paths, from trial passes.
//
// In:  two views with other camera paths, each lit by two sets of photons. Out: variances by block.
// What differs between the two sets of a view is the photons' part; what differs between the views,
// and alike for both sets, is the camera paths' part.
// Source: covariance of independent replicates.
#pragma once

#include "camera/pixel_window.h"
#include "film/luminance.h"
#include "measurement/pass_image.h"
#include "render/balance_rule.h"

#include <array>
#include <vector>

namespace sunfleck {

/// Luminance of each pixel.
using TrialPixels = std::vector<double>;

TrialPixels luminance_of(const PassImage& image);

/// A picture of so many columns and rows alone, from the first on.
TrialPixels thinned(const TrialPixels& pixels, const PixelWindow& window, int every);

/// How many of n there are, one of so many, from the first on.
constexpr int one_of(int n, int every) {
    return (n + every - 1) / every;
}

/// One view's trial passes.
using TrialPair = std::array<TrialPixels, 2>;

/// Of the blocks that are brighter than 1% of the picture: unbiased but for the division by their
/// measured brightness. All of them in the order of the grid.
/// @param paths  photon paths of each set.
std::vector<BlockVariance> block_variances(const BlockGrid& grid, const TrialPair& one,
                                           const TrialPair& other, double paths);

}  // namespace sunfleck
