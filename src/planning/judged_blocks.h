// Judged blocks: the blocks of pixels whose brightness sets the scale of errors.
// Equations: docs/method/sampling.md, eq. (40).
#pragma once

#include "aovs/objective.h"
#include "film/luminance.h"
#include "planning/pixel_buffer.h"

#include <vector>

namespace sunfleck::engine {

/// Blocks of 8 x 8 pixels, or of 8 x 8 cells. @param cells  side of these, in pixels.
BlockGrid judged_blocks(const PixelWindow& window, int cells = 1);

/// Returns the sum of the values in each block.
std::vector<double> block_sums(const BlockGrid& blocks, const PixelValues& values);

/// Returns the squared scale of errors of each block. @param light  summed by block.
std::vector<double> squared_scales(const BlockGrid& blocks, const std::vector<double>& light,
                                   Objective objective);

/// Returns the squared scale of errors of each pixel, that of its block.
/// @param light  of the pixels.
PixelValues squared_scales(const PixelWindow& window, const PixelValues& light,
                           Objective objective);

}  // namespace sunfleck::engine
