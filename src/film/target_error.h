// The error that --target-error limits: noise of the picture and bias of the gather radius.
// Equations: docs/method/errors.md, eqs. (33) and (34).
#pragma once

#include "aovs/objective.h"
#include "film/film.h"

#include <cmath>
#include <optional>

namespace sunfleck::engine {

/// Complete batches needed; with fewer, standard errors are themselves too uncertain.
inline constexpr std::uint64_t kTargetBatches = 4;

/// The terms that count.
struct ErrorTerms {
    bool bias = true;
    bool extrapolated = false;  // of the picture minus its bias
    Objective objective = Objective::relative;
};

/// Blocks count that are brighter than this share of the picture, as the objective has it
/// (aovs/objective.h); the error of those darker, down to kDarkest, is told apart.
inline constexpr double kDarkestThatCounts = 0.1;
inline constexpr double kDarkest = 0.01;

/// Errors of blocks over the scale of the objective: the brightness of the block, of blocks that
/// are bright enough; or the brightness of the picture, of all blocks.
struct TargetError {
    double noise = 0;  // the widened standard error below which 95% of these blocks are
    double bias = 0;   // as relative_bias(); zero if it does not count, does not exist, or is
                       // unknown
    std::optional<double> of_dark{};  // value() of the dark blocks; none if there are no such

    double value() const { return std::sqrt(noise * noise + bias * bias); }
};

/// Returns the factor of the present number of passes that reaches the target; 1 if it is reached.
/// Noise is inverse to the square root of passes, bias to passes^(1 - alpha).
/// @param target  positive.
/// @param alpha  of the radii, in (0, 1).
double times_passes_to(const TargetError& error, double target, double alpha);

/// Returns the number of further passes to the target.
double passes_left(const Film& film, const TargetError& error, double target, double alpha);

/// Returns the error that the objective of `terms` judges. Nothing with fewer than
/// kTargetBatches complete batches, if these are black, or if the picture is too dim for error
/// bars.
std::optional<TargetError> target_error(const Film& film, ErrorTerms terms);

/// Returns the bias of bright blocks over their luminance: the root mean square with its noise
/// subtracted, not negative. Nothing if bias.h has none, or for a black picture.
///
/// A quantile, as for noise, would measure the noise of the estimates, because the bias of a block
/// has 2 to 3.5 times the error of its mean.
std::optional<double> relative_bias(const Film& film);

}  // namespace sunfleck::engine
