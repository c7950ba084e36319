// Spots: pixels far brighter than the reference around them, which a mean error hides.
#pragma once

#include <cstddef>
#include <span>

namespace sunfleck::engine {

struct Spots {
    /// Pixels above the picture's mean that exceed three times the largest value of the reference
    /// in the 5 x 5 pixels around them.
    std::size_t count = 0;
    /// Share of the worst 0.1% of pixels in the sum of squared relative errors.
    double worst_share = 0;
};

/// @param reference, pixels  luminance, row by row. @param width  in pixels.
Spots spots_of(std::span<const double> reference, std::span<const double> pixels,
               std::size_t width);

}  // namespace sunfleck::engine
