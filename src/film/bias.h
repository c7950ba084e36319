// The bias of the discs' radius, estimated from how what photons bring falls as radii shrink.
//
// In:  a film whose passes had discs. Out: the bias of its mean (what to subtract), and standard
// errors, of the bias and of the mean without it. Means are over all passes; those of blocks and of
// the picture, and all errors, come from complete batches. Of first order: light is taken to be
// linear in the disc's area. Ordinary least squares (docs/method/method.md): unbiased whatever the
// batches' variances are; the errors take them to be equal, or as one over how often a batch
// counts. That they are for blocks and the picture. In a pixel early batches have less noise than
// late ones, and its errors come out too large by some 15%.
#pragma once

#include "film/disc_areas.h"
#include "film/error_bars.h"

#include <array>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// Of each pixel: RGB to subtract from its mean. Empty where disc_areas() has nothing.
std::vector<std::array<double, 3>> pixel_biases(const Film& film);

/// What to subtract from a luminance, and how well that is known.
struct Bias {
    double value = 0;
    double standard_error = 0;  // not widened
};

/// widening() for standard errors around a line, for which two numbers have been fitted.
/// @param film  of three complete batches at least.
inline double line_widening(const Film& film) {
    return student_widening(error_degrees(film) - 1);
}

/// Of the luminance of each block of 8 x 8 pixels, row after row. Empty where disc_areas() has
/// nothing.
std::vector<Bias> block_biases(const Film& film);

/// Of the luminance of the whole picture. Nothing where disc_areas() has nothing, or where photons
/// have brought no light in complete batches, and the picture is not black.
std::optional<Bias> image_bias(const Film& film);

/// Standard errors, not widened, of the luminance of each pixel, bias subtracted; not less than
/// they are where sampled direct light is noisy, nor where only an open batch has lit a pixel.
/// Empty where disc_areas() has nothing.
std::vector<double> extrapolated_pixel_errors(const Film& film);

/// The same for blocks, without that reserve.
std::vector<double> extrapolated_block_errors(const Film& film);

}  // namespace sunfleck::engine
