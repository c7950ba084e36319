// Pixel buffers: one number per pixel of a rectangle, with smoothing and upsampling.
//
// In and out: numbers in row-major order.
#pragma once

#include "aovs/pass_image.h"
#include "camera/pixel_window.h"

#include <vector>

namespace sunfleck::engine {

/// A number per pixel, such as luminance.
using PixelValues = std::vector<double>;

/// Returns the luminance of a pass, or of a part of one.
PixelValues luminance_of(const PassImage& image);

double mean_value(const PixelValues& pixels);

/// Smooths with binomial weights over a pixel and its eight neighbours.
PixelValues smoothed(const PixelValues& pixels, const PixelWindow& window);

/// Upsamples one value per cell to all pixels of the cell, after smoothing over neighbouring cells.
PixelValues upsampled(const PixelValues& pixels, const PixelCells& cells);

}  // namespace sunfleck::engine
