// Bias of the gather radius, estimated by regression of the photons' light on the disc area.
//
// In:  a film whose passes have gather discs. Out: the bias of its mean (what to subtract), and
// standard errors of the bias and of the corrected mean. Pixel means are over all passes; those of
// blocks and of the picture, and all errors, are from complete batches. The model is of first
// order: light is linear in the disc area. Ordinary least squares (docs/method/errors.md) is
// unbiased whatever the variances of the batches are. The errors assume equal variances, which
// batches of one plan have for blocks and the picture. In a pixel, early batches have less noise
// than late ones, and its errors are too large by about 15%.
// Equations: docs/method/errors.md, eqs. (29), (30) and (31).
#pragma once

#include "film/disc_areas.h"
#include "film/error_bars.h"

#include <array>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// Returns whether the bias of pixels is known: from four whole batches on, if radii have shrunk.
/// That of blocks and of the picture is known from early batches, too (batches.h).
bool has_pixel_biases(const Film& film);

/// Returns RGB to subtract from the mean of each pixel, the same in all of a photon cell. Empty
/// without has_pixel_biases().
std::vector<std::array<double, 3>> pixel_biases(const Film& film);

/// The bias of a luminance (to be subtracted), and its error.
struct Bias {
    double value = 0;
    double standard_error = 0;  // not widened
};

/// Returns the widening() of standard errors around a line, whose fit takes two degrees of freedom.
/// @param film  with at least three complete batches.
inline double line_widening(const Film& film) {
    return student_widening(error_degrees(film) - 1);
}

/// Returns the bias of the luminance of each block of 8 x 8 pixels, row by row. Empty if
/// disc_areas() has nothing.
std::vector<Bias> block_biases(const Film& film);

/// Returns the bias of the picture's luminance. Nothing if disc_areas() has nothing, or if complete
/// batches have no photons' light although the picture is not black.
std::optional<Bias> image_bias(const Film& film);

/// Returns standard errors, not widened, of the corrected luminance of each pixel. They are not
/// less than those of noisy sampled direct light, nor than those of a pixel that only an open batch
/// has lit. They take the photons' noise to be that of the whole cell, as discs make it: where it
/// is the pixel's own they are too large. Empty without has_pixel_biases().
std::vector<double> extrapolated_pixel_errors(const Film& film);

/// Returns standard errors of the corrected luminance of each block, without that lower bound.
/// Empty without has_pixel_biases().
std::vector<double> extrapolated_block_errors(const Film& film);

}  // namespace sunfleck::engine
