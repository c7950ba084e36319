// Numbers over seeds: means and ratios with their intervals, and how alike two orders are.
#pragma once

#include <vector>

namespace sunfleck::engine {

/// A number and its 95% interval.
struct Interval {
    double value = 0;
    double low = 0;
    double high = 0;
};

/// The 97.5% point of Student's t. @param freedom  degrees, at least one.
double student_t(double freedom);

/// @param values  at least one.
double mean_of(const std::vector<double>& values);

/// Mean of the values; without an interval (low = high = value) for fewer than two.
Interval mean_interval(const std::vector<double>& values);

/// The geometric mean of `a` over that of `b`, by Welch's interval of the logarithms. Values must
/// be positive; not a number where one is not, or a side has fewer than two.
Interval ratio_interval(const std::vector<double>& a, const std::vector<double>& b);

/// Spearman's rank correlation; ties share their mean rank. Both have the same size, at least two.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace sunfleck::engine
