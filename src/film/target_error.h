// What --target-error compares: one number for the noise of a picture and the bias of its discs.
#pragma once

#include "film/film.h"

#include <cmath>
#include <optional>

namespace sunfleck::engine {

/// Batches that target_error() needs: from fewer a standard error is itself too uncertain.
inline constexpr std::uint64_t kTargetBatches = 4;

/// What counts.
struct ErrorTerms {
    bool bias = true;
    bool extrapolated =
        false;  // of the picture less its bias: more noise, and no bias (to first order)
};

/// Relative errors.
struct TargetError {
    double noise = 0;  // the widened standard error that 95% of the bright blocks keep
    double bias = 0;   // relative_bias(); zero where it does not count, is not there, or not known

    double value() const { return std::sqrt(noise * noise + bias * bias); }
};

/// How many times the weight of the passes that there are brings the error down to the target: its
/// noise falls with their root, its bias with the area of the discs, as passes^(alpha - 1); 1 if it
/// is there.
/// @param target  positive. @param alpha  of the radii, in (0, 1).
double times_passes_to(const TargetError& error, double target, double alpha);

/// The same in passes to come, which count as often as the latest. @param film  has passes.
double passes_left(const Film& film, const TargetError& error, double target, double alpha);

/// Bright blocks are those above 1% of the mean luminance. Nothing with fewer than kTargetBatches
/// complete batches, or where these are black or the picture is too dim for error bars.
std::optional<TargetError> target_error(const Film& film, ErrorTerms terms);

/// Bias of bright blocks over their luminance: the root of the mean square, its noise subtracted;
/// never below zero. Nothing where bias.h knows none, or in a black picture.
///
/// A quantile, as for noise, would be one of the estimates' noise: a block's bias is known 2 to 3.5
/// times less well than its mean.
std::optional<double> relative_bias(const Film& film);

}  // namespace sunfleck::engine
