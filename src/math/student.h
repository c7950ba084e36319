// Student's t: how far a mean may lie from the truth where its standard error is estimated, too.
#pragma once

namespace sunfleck::engine {

/// Probability that a normal number lies within two standard deviations of its mean.
inline constexpr double kWithinTwo = 0.954499736;

/// Returns the distance from zero within which a number of Student's distribution lies.
/// Accurate to three digits up to 10,000 degrees of freedom; beyond, the value for 10,000.
/// @param within  probability, in (0, 1). @param degrees  of freedom, not necessarily whole, at
///                least one.
double student_quantile(double within, double degrees);

/// Returns the factor by which a standard error that was estimated with so many degrees of freedom
/// is widened, so that two of them hold the truth as often as with a known one: 95.4%. 7.0, 2.3,
/// 1.7, 1.2 for 1, 2, 3, 7 degrees.
inline double student_widening(double degrees) {
    return student_quantile(kWithinTwo, degrees) / 2;
}

}  // namespace sunfleck::engine
