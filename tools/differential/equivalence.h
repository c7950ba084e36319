// Whether two estimators agree: an equivalence test of two means, with a band that does not matter.
//
// In:  independent values of each, one a render. Out: equal, different or undecided.
// Source: Schuirmann, A comparison of the two one-sided tests procedure (1987); degrees of freedom:
// Welch (1947).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace sunfleck::engine::differential {

enum class Verdict { equal, different, undecided };

std::string_view name(Verdict verdict);

/// Mean of independent values, its standard error and its degrees of freedom.
struct MeanOf {
    double mean = 0;
    double error = 0;
    double degrees = 0;
};

/// @param values  at least two.
/// @param prior  variance of one value that is known from elsewhere, and how many degrees of
///               freedom it stands for; none by default.
struct Prior {
    double variance = 0;
    double degrees = 0;
};
MeanOf mean_of(const std::vector<double>& values, const Prior& prior = {});

/// A mean over another, less one, and its standard error.
struct Excess {
    double value = 0;
    double error = 0;
};
/// @return nothing if b is not positive.
std::optional<Excess> excess_of(const MeanOf& a, const MeanOf& b);

/// P(T > t) for Student's t with that many degrees of freedom, not necessarily an integer.
double student_tail(double t, double degrees);

/// Differences within `band` do not matter. Different: with error probability `significance` the
/// true difference is beyond the band. Equal: within it, with 1%.
Verdict decide(const MeanOf& a, const MeanOf& b, double band, double significance);

}  // namespace sunfleck::engine::differential
