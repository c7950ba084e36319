// Standard errors from complete batches, the independent samples that a film has.
//
// A quantity y (luminance of a pixel, a block, the picture) has the mean m and the sum of squares
// q over n batches; the mean's standard error is sqrt((q/n - m^2) / (n - 1)). It holds also when
// batches differ in variance, as they do while radii shrink. Where some count more than once, q/n
// is over how often all count; then it holds if a batch's variance is as one over how often it
// counts. Where camera paths make all noise, and the first of n batches counts once and the others
// four times, it is 15% too small for n = 3, and 4% for n = 8. From few batches the standard error
// is itself uncertain: whatever is reported is widened by Student's t (widening()), whatever is
// computed on is not, for its square has no bias. Precision: of y about 2^-26 relative
// and 2^-32 absolute (the squares' unit is 2^-64).
#pragma once

#include "film/film.h"
#include "math/student.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

/// Of pictures that are darker the squares say nothing.
inline constexpr double kDimmestMean = 0x1p-18;

/// Is any of them other than zero?
bool is_lit(const FixedPoints& sums);

struct MeanError {
    double mean = 0;            // over complete batches
    double standard_error = 0;  // of that mean, not widened
};

/// Degrees of freedom of standard errors: one less than complete batches, and fewer where these
/// count unlike, as if their variances were equal all the same (Welch and Satterthwaite).
/// @param film  of two complete batches at least.
double error_degrees(const Film& film);

/// Factor by which the standard errors below are widened where they are reported, so that the true
/// mean lies within two of them in 95% of all renders, however few batches there are.
/// @param film  of two complete batches at least.
inline double widening(const Film& film) {
    return student_widening(error_degrees(film));
}

/// Luminance of each pixel. Empty with fewer than two complete batches. A pixel that only an open
/// batch has lit, so that complete ones know nothing of it: the mean over all passes is its error.
std::vector<MeanError> pixel_errors(const Film& film);

/// Luminance of each block of 8 x 8 pixels, row after row; smaller at the right and lower edges.
/// Empty with fewer than two complete batches.
std::vector<MeanError> block_errors(const Film& film);

/// Luminance of the whole picture: the error that all pixels share is in this one, too. Nothing
/// with fewer than two complete batches, or where these are black and the picture is not.
std::optional<MeanError> image_error(const Film& film);

/// Mean luminance of the picture: over all passes, each as often as it counts there; zero without
/// passes.
double image_mean(const Film& film);
/// The same of what photons have brought; zero where there are no discs.
double image_mean_by_photons(const Film& film);

/// Is there light, but too little for standard errors to be known?
inline bool is_too_dim(const Film& film) {
    const double mean = image_mean(film);
    return mean > 0 && mean < kDimmestMean;
}

}  // namespace sunfleck::engine
