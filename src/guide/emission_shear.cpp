// Regression: with P the inverse of the dimensions' correlations, 1 / P_ss is the share of
// dimension s's variance that the other dimensions do not explain, and -P_st / P_ss its slopes.
#include "guide/emission_shear.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

using Matrix = std::array<EmissionPoint, kGuidedDimensions>;

struct Moments {
    EmissionPoint mean{};
    EmissionPoint deviation{};  // standard; zero where a dimension hardly varies
    Matrix correlation{};
};

Moments moments_of(std::span<const WeightedEmission> points, const EmissionBox& box) {
    constexpr double kLeastDeviation = 1e-9;  // of the box's width
    Moments m;
    double sum = 0;
    for (const WeightedEmission& p : points) sum += p.weight;
    for (const WeightedEmission& p : points)
        for (std::size_t s = 0; s < kGuidedDimensions; ++s)
            m.mean[s] += p.point[s] * (p.weight / sum);
    for (const WeightedEmission& p : points)
        for (std::size_t s = 0; s < kGuidedDimensions; ++s)
            for (std::size_t t = 0; t <= s; ++t)
                m.correlation[s][t] +=
                    (p.point[s] - m.mean[s]) * (p.point[t] - m.mean[t]) * (p.weight / sum);
    for (std::size_t s = 0; s < kGuidedDimensions; ++s) {
        const double deviation = std::sqrt(m.correlation[s][s]);
        if (deviation > kLeastDeviation * (box.high[s] - box.low[s])) m.deviation[s] = deviation;
    }
    for (std::size_t s = 0; s < kGuidedDimensions; ++s)
        for (std::size_t t = 0; t <= s; ++t) {
            const double scale = m.deviation[s] * m.deviation[t];
            const double r = scale > 0 ? m.correlation[s][t] / scale : 0;
            m.correlation[s][t] = m.correlation[t][s] = s == t ? 1 : r;
        }
    return m;
}

/// Accepts so much of row k of both from row s that a[s][k] becomes zero.
void clear(Matrix& a, Matrix& b, std::size_t s, std::size_t k) {
    const double factor = a[s][k];
    for (std::size_t t = 0; t < kGuidedDimensions; ++t) {
        a[s][t] -= factor * a[k][t];
        b[s][t] -= factor * b[k][t];
    }
}

/// The inverse of a matrix of correlations, by elimination; a little is added to its diagonal.
Matrix inverse(Matrix a) {
    constexpr double kRidge = 1e-10;
    Matrix b{};
    for (std::size_t s = 0; s < kGuidedDimensions; ++s) {
        a[s][s] += kRidge;
        b[s][s] = 1;
    }
    for (std::size_t k = 0; k < kGuidedDimensions; ++k) {
        const double pivot = a[k][k];  // positive: the matrix is
        for (std::size_t t = 0; t < kGuidedDimensions; ++t) {
            a[k][t] /= pivot;
            b[k][t] /= pivot;
        }
        for (std::size_t s = 0; s < kGuidedDimensions; ++s)
            if (s != k) clear(a, b, s, k);
    }
    return b;
}

}  // namespace

FoundShear best_shear(std::span<const WeightedEmission> points, const EmissionBox& box) {
    const Moments m = moments_of(points, box);
    const Matrix precision = inverse(m.correlation);
    FoundShear best;
    std::size_t dimension = 0;
    for (std::size_t s = 1; s < kGuidedDimensions; ++s)
        if (m.deviation[s] > 0 && precision[s][s] > precision[dimension][dimension]) dimension = s;
    if (!(precision[dimension][dimension] > 1) || !(m.deviation[dimension] > 0)) return best;
    best.gain = 0.5 * double{std::log(static_cast<float>(precision[dimension][dimension]))};
    best.shear = {
        dimension, box.low[dimension], box.high[dimension] - box.low[dimension], {}, m.mean};
    for (std::size_t t = 0; t < kGuidedDimensions; ++t)
        if (t != dimension && m.deviation[t] > 0)
            best.shear.slope[t] = -precision[dimension][t] / precision[dimension][dimension] *
                                  (m.deviation[dimension] / m.deviation[t]);
    return best;
}

}  // namespace sunfleck::engine
