// Two one-sided tests by Student's t, with the incomplete beta function behind it.
#include "differential/equivalence.h"

#include <cmath>

namespace sunfleck::engine::differential {
namespace {

constexpr double kEqualSignificance = 0.01;

/// Continued fraction of the incomplete beta function (DLMF 8.17.22), by Lentz's method.
double beta_fraction(double a, double b, double x) {
    constexpr double kTiny = 1e-300;
    double c = 1;
    double d = 1 / (1 - (a + b) * x / (a + 1));
    double fraction = d;
    for (int m = 1; m < 10000; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        double step = 1;
        for (const double numerator : {even, odd}) {
            d = 1 + numerator * d;
            c = 1 + numerator / c;
            if (std::abs(d) < kTiny) d = kTiny;
            if (std::abs(c) < kTiny) c = kTiny;
            d = 1 / d;
            step = c * d;
            fraction *= step;
        }
        if (std::abs(step - 1) < 1e-14) break;
    }
    return fraction;
}

/// Regularised incomplete beta function I_x(a, b).
double incomplete_beta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    int sign = 0;
    const double scale = std::exp(::lgamma_r(a + b, &sign) - ::lgamma_r(a, &sign) -
                                  ::lgamma_r(b, &sign) + a * std::log(x) + b * std::log1p(-x));
    if (x < (a + 1) / (a + b + 2)) return scale * beta_fraction(a, b, x) / a;
    return 1 - scale * beta_fraction(b, a, 1 - x) / b;
}

}  // namespace

std::string_view name(Verdict verdict) {
    switch (verdict) {
        case Verdict::equal:
            return "equal";
        case Verdict::different:
            return "different";
        case Verdict::undecided:
            break;
    }
    return "undecided";
}

MeanOf mean_of(const std::vector<double>& values, const Prior& prior) {
    const auto count = static_cast<double>(values.size());
    double sum = 0;
    for (const double value : values) sum += value;
    const double mean = sum / count;
    double squares = prior.degrees * prior.variance;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double degrees = count - 1 + prior.degrees;
    return {mean, std::sqrt(squares / degrees / count), degrees};
}

std::optional<Excess> excess_of(const MeanOf& a, const MeanOf& b) {
    if (b.mean <= 0) return {};
    const double ratio = a.mean / b.mean;
    return Excess{ratio - 1, std::hypot(a.error, ratio * b.error) / b.mean};
}

double student_tail(double t, double degrees) {
    const double half = incomplete_beta(degrees / 2, 0.5, degrees / (degrees + t * t)) / 2;
    return t > 0 ? half : 1 - half;
}

Verdict decide(const MeanOf& a, const MeanOf& b, double band, double significance) {
    const double difference = std::abs(a.mean - b.mean);
    const double variance_a = a.error * a.error;
    const double variance_b = b.error * b.error;
    const double error = std::sqrt(variance_a + variance_b);
    if (error <= 0) return difference > band ? Verdict::different : Verdict::equal;
    const double degrees =
        (variance_a + variance_b) * (variance_a + variance_b) /
        (variance_a * variance_a / a.degrees + variance_b * variance_b / b.degrees);
    if (student_tail((difference - band) / error, degrees) < significance)
        return Verdict::different;
    if (student_tail((band - difference) / error, degrees) < kEqualSignificance)
        return Verdict::equal;
    return Verdict::undecided;
}

}  // namespace sunfleck::engine::differential
