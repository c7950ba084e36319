// Statistics over seeds: means and ratios with confidence intervals, and rank correlation.
#pragma once

#include <vector>

namespace sunfleck::engine {

/// A value and its 95% confidence interval.
struct Interval {
    double value = 0;
    double low = 0;
    double high = 0;
};

/// Returns the 97.5% quantile of Student's t. @param freedom  degrees of freedom, at least one.
double student_t(double freedom);

/// @param values  at least one.
double mean_of(const std::vector<double>& values);

/// Returns the mean of the values; low = high = value for fewer than two.
Interval mean_interval(const std::vector<double>& values);

/// Returns the ratio of the geometric means of `a` and `b`, with Welch's interval of the
/// logarithms. NaN if a value is not positive, or if a side has fewer than two.
Interval ratio_interval(const std::vector<double>& a, const std::vector<double>& b);

/// Returns Spearman's rank correlation with mean ranks for ties. Both have equal sizes, at least
/// two.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace sunfleck::engine
