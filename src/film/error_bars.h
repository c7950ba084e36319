// Error bars: standard errors by batch means, from the complete batches of a film.
//
// A quantity y (luminance of a pixel, a block, the picture) has the mean m over the n passes of b
// batches, and the sum q of the squared means of batches, each times its passes; the standard error
// of the mean is sqrt((q/n - m^2) / (b - 1)). It also holds if batches of equal length differ in
// variance, as they do while radii shrink and plans change. With few
// batches the standard error is itself uncertain: reported errors are widened by Student's t
// (widening()); errors used in computations are not, because their square is unbiased. The
// precision of y is about 2^-26 relative and 2^-32 absolute (the unit of the squares is 2^-64).
// Source: Conway 1963; Schmeiser 1982 (batch means).
// Equations: docs/method/errors.md, eqs. (26) and (27).
#pragma once

#include "film/film.h"
#include "math/student.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

/// Below this mean luminance the unit of the squares, 2^-64, is too coarse for standard errors.
inline constexpr double kDimmestMean = 0x1p-18;

/// Returns whether any sum is not zero.
bool is_lit(const FixedPoints& sums);

struct MeanError {
    double mean = 0;            // over complete batches
    double standard_error = 0;  // of that mean, not widened
};

/// Returns the degrees of freedom of standard errors: complete batches minus one.
/// @param film  with at least two complete batches.
inline double error_degrees(const Film& film) {
    return film.batches().count - 1;
}

/// Returns the factor that widens reported standard errors, so that the true mean is within two of
/// them in 95% of all renders, for any number of batches.
/// @param film  with at least two complete batches.
inline double widening(const Film& film) {
    return student_widening(error_degrees(film));
}

/// Returns the errors of the luminance of each pixel. Empty with fewer than two complete batches.
/// For a pixel with light in an open batch alone, the error is the mean over all passes.
std::vector<MeanError> pixel_errors(const Film& film);

/// Returns the errors of the luminance of each block of 8 x 8 pixels, row by row; blocks at the
/// right and lower edges are smaller. Empty with fewer than two complete batches.
std::vector<MeanError> block_errors(const Film& film);

/// Returns the error of the picture's luminance, which includes errors that all pixels share.
/// Nothing with fewer than two complete batches, or if these are black and the picture is not.
std::optional<MeanError> image_error(const Film& film);

/// Returns the mean luminance of the picture; zero without passes.
double image_mean(const Film& film);
/// Returns the mean luminance of the light of photons; zero if the film does not keep it apart.
double image_mean_by_photons(const Film& film);

/// Returns whether there is light, but too little for standard errors.
inline bool is_too_dim(const Film& film) {
    const double mean = image_mean(film);
    return mean > 0 && mean < kDimmestMean;
}

}  // namespace sunfleck::engine
