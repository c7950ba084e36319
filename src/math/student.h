// Student's t distribution, for confidence intervals where the standard error is estimated, too.
// Equations: docs/method/errors.md, eq. (27).
#pragma once

namespace sunfleck::engine {

/// Probability that a normal number lies within two standard deviations of its mean.
inline constexpr double kWithinTwo = 0.954499736;

/// Returns the distance from zero within which a number of Student's distribution lies. It is
/// accurate to three digits up to 10,000 degrees of freedom; beyond, the value for 10,000 is used.
/// @param within  probability, in (0, 1).
/// @param degrees  degrees of freedom, at least one; not necessarily an integer.
double student_quantile(double within, double degrees);

/// Returns the factor that widens a standard error estimated with these degrees of freedom, so that
/// two standard errors hold the truth with probability 95.4% as for a known error. The factors for
/// 1, 2, 3, 7 degrees are 7.0, 2.3, 1.7, 1.2.
inline double student_widening(double degrees) {
    return student_quantile(kWithinTwo, degrees) / 2;
}

}  // namespace sunfleck::engine
