// Numbers by pixel of a rectangle, and the means of neighbours.
//
// In and out: a number a pixel, row by row.
#pragma once

#include "aovs/pass_image.h"
#include "camera/pixel_window.h"

#include <vector>

namespace sunfleck::engine {

/// Of each pixel, such as its luminance.
using PixelValues = std::vector<double>;

/// Of a pass, or a part of one.
PixelValues luminance_of(const PassImage& image);

double mean_value(const PixelValues& pixels);

/// Binomial weights over a pixel and its eight neighbours.
PixelValues smoothed(const PixelValues& pixels, const PixelWindow& window);

/// What one pixel of each cell tells of all: smoothed among themselves, then each for its cell.
PixelValues upsampled(const PixelValues& pixels, const PixelCells& cells);

}  // namespace sunfleck::engine
