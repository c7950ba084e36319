// Tail probabilities for statistical tests: chi-square, normal, and a two-sided test of a mean.
//
// In:  statistics computed by a test, at a fixed seed. Out: probabilities in [0,1].
// Source: NIST Digital Library of Mathematical Functions, sections 8.7, 8.9 (incomplete gamma);
// the quantile inverts the tail by bisection.
#pragma once

#include <cmath>
#include <limits>

namespace sunfleck::engine::testing_support {

namespace detail {

/// log Gamma(a) for a = 1/2, 1, 3/2, ...: what chi-square needs. (std::lgamma writes a global.)
inline double log_gamma_of_half(double a) {
    double sum = 0;
    while (a > 1.25) {
        a -= 1;
        sum += std::log(a);
    }
    return a < 0.75 ? sum + 0.5 * std::log(3.14159265358979323846) : sum;
}

/// P(a, x) by its power series (DLMF 8.7.1): for x < a + 1.
inline double lower_gamma_series(double a, double x) {
    double term = 1 / a;
    double sum = term;
    for (int n = 1; n < 100000 && term > sum * 1e-17; ++n) {
        term *= x / (a + n);
        sum += term;
    }
    return sum * std::exp(a * std::log(x) - x - log_gamma_of_half(a));
}

/// Q(a, x) by its continued fraction (DLMF 8.9.2, evaluated as by Lentz): for x >= a + 1.
inline double upper_gamma_fraction(double a, double x) {
    constexpr double kTiny = 1e-300;
    double b = x + 1 - a;
    double c = 1 / kTiny;
    double d = 1 / b;
    double fraction = d;
    for (int n = 1; n < 100000; ++n) {
        const double numerator = -n * (n - a);
        b += 2;
        d = 1 / std::copysign(std::fmax(std::abs(numerator * d + b), kTiny), numerator * d + b);
        c = b + numerator / c;
        if (std::abs(c) < kTiny) c = kTiny;
        fraction *= c * d;
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return fraction * std::exp(a * std::log(x) - x - log_gamma_of_half(a));
}

}  // namespace detail

/// Upper tail of the chi-square distribution: how probable a statistic at least as large is.
/// @param dof  degrees of freedom, positive.
inline double chi_square_p(double statistic, int dof) {
    if (!(statistic > 0)) return std::isnan(statistic) ? 0 : 1;
    if (std::isinf(statistic)) return 0;
    const double a = 0.5 * dof;
    const double x = 0.5 * statistic;
    if (x < a + 1) return 1 - detail::lower_gamma_series(a, x);
    return detail::upper_gamma_fraction(a, x);
}

/// Two-sided: the probability that a standard normal number is at least |z| from zero.
inline double normal_p(double z) {
    return std::isnan(z) ? 0 : std::erfc(std::abs(z) / std::sqrt(2.0));
}

/// The number below which a standard normal number lies with this probability.
/// @param probability  in the open interval (0,1). Accurate to about 1e-12.
inline double normal_quantile(double probability) {
    double low = -40;
    double high = 40;
    for (int step = 0; step < 64; ++step) {
        const double middle = 0.5 * (low + high);
        const double below = 0.5 * std::erfc(-middle / std::sqrt(2.0));
        (below < probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Two-sided z test of a mean: the probability of a deviation at least this large.
/// @param standard_error  of `mean`; with zero only exact agreement is probable.
inline double mean_p(double mean, double expected, double standard_error) {
    if (standard_error > 0) return normal_p((mean - expected) / standard_error);
    return mean == expected ? 1 : 0;
}

/// The significance for each of `count` tests that together raise a false alarm with `total`.
inline double shared_significance(double total, int count) {
    return total / count;
}

}  // namespace sunfleck::engine::testing_support
