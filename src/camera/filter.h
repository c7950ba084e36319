// The five pixel filters of pbrt-v4, with importance sampling of |f|.
#pragma once

#include "math/vector.h"

#include <vector>

namespace sunfleck::engine {

enum class FilterKind { box, triangle, gaussian, mitchell, sinc };

struct FilterSettings {
    FilterKind kind = FilterKind::gaussian;
    Vec2d radius{1.5, 1.5};  // pixels
    double sigma = 0.5;      // gaussian
    double b = 1.0 / 3;      // mitchell
    double c = 1.0 / 3;      // mitchell
    double tau = 3;          // sinc
};

/// Returns the filter's value, pbrt-v4's up to a factor; zero outside the radius. Gaussian:
/// exp(-x^2 / (2 sigma^2)) minus its value at the radius. Mitchell: the cubic of 2 x / radius
/// (Mitchell and Netravali 1988). Sinc: sinc(x) sinc(x / tau), x in pixels.
double filter_value(const FilterSettings& filter, const Vec2d& offset);

/// Returns the integral of filter_value() over the plane in pixels squared: exact for box and
/// triangle, else by Simpson's rule with 1024 intervals per axis.
double filter_integral(const FilterSettings& filter);

struct FilterSample {
    Vec2d offset;      // from the centre of the pixel, in pixels
    float weight = 1;  // f / (pdf * integral of f); either sign for mitchell and sinc
};

/// Samples offsets by inversion of the CDF, axis by axis, since all five filters are products. Box
/// and triangle are exact. The others use the CDF of a density that is linear between 1025 values
/// of |f|; the weight corrects the difference. The weight is within 1e-3 of +-1 times a constant,
/// except in the few cells where f changes its sign or reaches zero. Its mean is one. The integral
/// uses Simpson's rule on the table's nodes and midpoints.
class FilterSampler {
public:
    /// @param settings  radii and sigma are positive; f is not zero everywhere.
    explicit FilterSampler(const FilterSettings& settings);
    FilterSample sample(const Vec2d& u) const;

private:
    struct Axis {
        std::vector<double>
            density;  // |f| at the ends of cells of equal width; empty if a formula is used
        std::vector<double> cdf;  // of the density, which is linear in each cell
        double integral = 0;      // integral of f over that of the density
    };
    static Axis make_axis(const FilterSettings& settings, double radius);
    double sample_axis(const Axis& axis, double radius, double u, double& weight) const;

    FilterSettings settings_;
    Axis x_;
    Axis y_;
};

}  // namespace sunfleck::engine
