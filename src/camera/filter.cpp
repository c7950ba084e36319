// Pixel filters: their formulas along one axis, and offsets drawn from |f|.
#include "camera/filter.h"

#include "math/trigonometry.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

namespace {

constexpr std::size_t kCells = 1024;  // a multiple of four: Mitchell's pieces end at nodes

/// Same bits everywhere: the float function.
double gauss(double x, double sigma) {
    const double exponent = -x * x / (2 * sigma * sigma);
    return static_cast<double>(std::exp(static_cast<float>(exponent)));
}

/// sin(pi x) / (pi x).
double sinc(double x) {
    if (std::abs(x) < 1e-8) return 1;
    return sin_cos_2pi(x / 2).sin / (kPiDouble * x);
}

/// @param x  not negative; zero beyond two.
double mitchell(double x, double b, double c) {
    if (x <= 1)
        return (((12 - 9 * b - 6 * c) * x + (-18 + 12 * b + 6 * c)) * x * x + (6 - 2 * b)) / 6;
    if (x <= 2)
        return ((((-b - 6 * c) * x + (6 * b + 30 * c)) * x - (12 * b + 48 * c)) * x +
                (8 * b + 24 * c)) /
               6;
    return 0;
}

double axis_value(const FilterSettings& filter, double radius, double offset) {
    const double x = std::abs(offset);
    if (!(x <= radius)) return 0;
    switch (filter.kind) {
        case FilterKind::box:
            return 1;
        case FilterKind::triangle:
            return radius - x;
        case FilterKind::gaussian:
            return std::max(0.0, gauss(x, filter.sigma) - gauss(radius, filter.sigma));
        case FilterKind::mitchell:
            return mitchell(2 * x / radius, filter.b, filter.c);
        case FilterKind::sinc:
            return sinc(x) * sinc(x / filter.tau);
    }
    return 0;
}

/// axis_value() by place, in cells from the left end.
struct AxisCells {
    const FilterSettings& filter;
    double radius;

    double operator()(double cell) const {
        return axis_value(filter, radius, (2 * cell / kCells - 1) * radius);
    }
    /// Integral over cell i, in cells: Simpson's rule.
    double over(std::size_t i) const {
        const auto left = static_cast<double>(i);
        return ((*this)(left) + 4 * (*this)(left + 0.5) + (*this)(left + 1)) / 6;
    }
};

double axis_integral(const FilterSettings& filter, double radius) {
    if (filter.kind == FilterKind::box) return 2 * radius;
    if (filter.kind == FilterKind::triangle) return radius * radius;
    const AxisCells value{filter, radius};
    double sum = 0;
    for (std::size_t i = 0; i < kCells; ++i) sum += value.over(i);
    return sum * (2 * radius / kCells);
}

/// Quantile of the triangle of half width one.
double tent(double u) {
    return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
}

/// Where in [0,1] a density that runs from a to b has the share v of its mass below.
double linear_quantile(double a, double b, double v) {
    const double slope = a + std::sqrt(a * a + v * (b * b - a * a));
    return slope > 0 ? std::min(v * (a + b) / slope, 1.0) : 0;
}

}  // namespace

double filter_value(const FilterSettings& filter, const Vec2d& offset) {
    return axis_value(filter, filter.radius.x, offset.x) *
           axis_value(filter, filter.radius.y, offset.y);
}

double filter_integral(const FilterSettings& filter) {
    return axis_integral(filter, filter.radius.x) * axis_integral(filter, filter.radius.y);
}

FilterSampler::FilterSampler(const FilterSettings& settings) : settings_(settings) {
    if (settings.kind == FilterKind::box || settings.kind == FilterKind::triangle) return;
    x_ = make_axis(settings, settings.radius.x);
    y_ = make_axis(settings, settings.radius.y);
}

FilterSampler::Axis FilterSampler::make_axis(const FilterSettings& settings, double radius) {
    const AxisCells value{settings, radius};
    Axis axis;
    double sum = 0;
    axis.cdf.push_back(0);
    axis.density.push_back(std::abs(value(0)));
    for (std::size_t i = 0; i < kCells; ++i) {
        const auto left = static_cast<double>(i);
        sum += value.over(i);
        axis.density.push_back(std::abs(value(left + 1)));
        axis.cdf.push_back(axis.cdf.back() + (axis.density[i] + axis.density[i + 1]) / 2);
    }
    const double mass = axis.cdf.back();
    for (double& below : axis.cdf) below /= mass;
    axis.integral = sum / mass;
    return axis;
}

double FilterSampler::sample_axis(const Axis& axis, double radius, double u, double& weight) const {
    if (settings_.kind == FilterKind::box) return (2 * u - 1) * radius;
    if (settings_.kind == FilterKind::triangle) return tent(u) * radius;
    const auto end = std::upper_bound(axis.cdf.begin() + 1, axis.cdf.end() - 1, u);
    const auto i = static_cast<std::size_t>(end - axis.cdf.begin()) - 1;
    const double a = axis.density[i];
    const double b = axis.density[i + 1];
    const double share = (u - axis.cdf[i]) / (axis.cdf[i + 1] - axis.cdf[i]);
    const double t = linear_quantile(a, b, std::clamp(share, 0.0, 1.0));
    const double offset = (2 * (static_cast<double>(i) + t) / kCells - 1) * radius;
    const double density = a + t * (b - a);
    const double value = axis_value(settings_, radius, offset);
    weight *= density > 0 ? value / (density * axis.integral) : 0;
    return offset;
}

FilterSample FilterSampler::sample(const Vec2d& u) const {
    double weight = 1;
    const double x = sample_axis(x_, settings_.radius.x, u.x, weight);
    const double y = sample_axis(y_, settings_.radius.y, u.y, weight);
    return {Vec2d(x, y), static_cast<float>(weight)};
}

}  // namespace sunfleck::engine
