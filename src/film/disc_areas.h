// DiscAreas: the disc areas of a film's passes relative to pass 0, the regressor of bias
// estimation.
//
// To first order the mean light of photons is linear in the disc area s, y = a + c s
// (docs/method/errors.md): c s is the bias, a the unbiased light. For a batch, s is the mean over
// its passes. In the mean of the picture each pass has its share in the picture
// (Film::share_of_pass()). In the regression a batch counts as often as it has passes.
// Equations: docs/method/errors.md, eqs. (28) and (32).
#pragma once

#include "film/film.h"

#include <optional>

namespace sunfleck::engine {

/// Complete batches needed for a slope; with fewer, its standard error is itself too uncertain.
inline constexpr std::uint64_t kBiasBatches = 4;

/// Limit of the standard error of the bias over that of the mean. Beyond it, radii have hardly
/// shrunk (alpha near one, late passes alone), and the bias cannot be measured.
inline constexpr double kLargestLever = 10;

struct DiscAreas {
    CompleteBatches complete;
    double mean = 0;     // area over complete batches
    double squares = 0;  // sum of (s - mean)^2 over the passes of complete batches, by weight
    double mean_of_passes = 0;  // of the picture: times the slope, its bias

    // With sums Y of light and M of light times the area of its whole batch, over all passes, the
    // slope is (M - share Y) / divisor. Both sums are linear in a and c, so the slope is unbiased.
    double share = 0;
    double divisor = 0;  // zero as long as early batches count

    /// Returns the variance of the bias over that of a pass.
    double bias_variance() const { return mean_of_passes * mean_of_passes / squares; }
};

/// Returns nothing without discs, with too few batches, or if radii have hardly shrunk.
std::optional<DiscAreas> disc_areas(const Film& film);

}  // namespace sunfleck::engine
