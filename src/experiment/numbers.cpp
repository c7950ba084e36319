// Welch's ratio, Spearman's ranks.
#include "experiment/numbers.h"

#include "math/statistics.h"
#include "math/student.h"

#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

RunningMean logarithms(const std::vector<double>& values) {
    RunningMean logs;
    for (const double v : values) logs.add(std::log(v));
    return logs;
}

std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<double> rank;
    for (const double v : values) {
        double below = 0;
        double same = 0;
        for (const double other : values) {
            below += other < v ? 1 : 0;
            same += other == v ? 1 : 0;
        }
        rank.push_back(below + (same + 1) / 2);
    }
    return rank;
}

}  // namespace

double student_t(double freedom) {
    return student_quantile(0.95, freedom);
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

Interval mean_interval(const std::vector<double>& values) {
    RunningMean mean;
    for (const double v : values) mean.add(v);
    if (values.size() < 2) return {mean.mean(), mean.mean(), mean.mean()};
    const double half = student_t(static_cast<double>(values.size() - 1)) * mean.standard_error();
    return {mean.mean(), mean.mean() - half, mean.mean() + half};
}

Interval ratio_interval(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() < 2 || b.size() < 2) return {kUnknown, kUnknown, kUnknown};
    const RunningMean x = logarithms(a);
    const RunningMean y = logarithms(b);
    const double u = x.standard_error() * x.standard_error();
    const double v = y.standard_error() * y.standard_error();
    const double difference = x.mean() - y.mean();
    if (!std::isfinite(difference)) return {kUnknown, kUnknown, kUnknown};
    if (u + v == 0) return {std::exp(difference), std::exp(difference), std::exp(difference)};
    const double freedom =
        (u + v) * (u + v) /
        (u * u / static_cast<double>(a.size() - 1) + v * v / static_cast<double>(b.size() - 1));
    const double half = student_t(freedom) * std::sqrt(u + v);
    return {std::exp(difference), std::exp(difference - half), std::exp(difference + half)};
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double> x = ranks(a);
    const std::vector<double> y = ranks(b);
    const double mean = (static_cast<double>(a.size()) + 1) / 2;
    double xy = 0;
    double xx = 0;
    double yy = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        xy += (x[i] - mean) * (y[i] - mean);
        xx += (x[i] - mean) * (x[i] - mean);
        yy += (y[i] - mean) * (y[i] - mean);
    }
    return xy / std::sqrt(xx * yy);
}

}  // namespace sunfleck::engine
