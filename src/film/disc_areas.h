// The areas of the discs in a film's passes, over that in pass 0: what the light that photons bring
// is regressed on.
//
// To first order the mean of that light, y = a + c s, is linear in the area s
// (docs/method/method.md): c s is the bias, a the light without it. In a batch s is the mean over
// its passes. Passes and batches count as often as they do in the film, in all sums and means; in
// that of the picture as they do there.
#pragma once

#include "film/film.h"

#include <optional>

namespace sunfleck::engine {

/// Complete batches that a slope needs: from fewer, its standard error is itself too uncertain.
inline constexpr std::uint64_t kBiasBatches = 4;

/// The standard error of the bias may be at most so many times that of the mean. Beyond, radii have
/// hardly shrunk (alpha near one, late passes alone), and the bias cannot be seen.
inline constexpr double kLargestLever = 10;

struct DiscAreas {
    double batches = 0;         // complete ones
    double weight = 0;          // how often they count together
    double mean = 0;            // over complete batches
    double squares = 0;         // of complete batches: sum of (s - mean)^2
    double mean_of_passes = 0;  // of the picture: with the slope, the bias of the picture

    // Of sums over all passes, Y of light and M of light times its batch's area, the slope is
    // (M - share Y) / divisor: both sums are linear in a and c, so it is unbiased.
    double share = 0;
    double divisor = 0;

    /// Variance of the bias over that of a batch that counts once.
    double bias_variance() const { return mean_of_passes * mean_of_passes / squares; }
};

/// Nothing without discs, with too few batches, or where radii have hardly shrunk.
std::optional<DiscAreas> disc_areas(const Film& film);

}  // namespace sunfleck::engine
