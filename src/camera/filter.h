// The five pixel filters of pbrt-v4, by importance sampling of |f|.
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

/// The filter's value (not normalised: pbrt-v4's up to a factor). Zero outside the radius.
/// Gaussian: exp(-x^2 / (2 sigma^2)) less its value at the radius. Mitchell: the classic cubic of
/// 2 x / radius (Mitchell and Netravali 1988). Sinc: sinc(x) sinc(x / tau), x in pixels.
double filter_value(const FilterSettings& filter, const Vec2d& offset);

/// Integral of filter_value() over the plane, in pixels squared: exact for box and triangle, else
/// by Simpson's rule over 1024 pieces an axis.
double filter_integral(const FilterSettings& filter);

struct FilterSample {
    Vec2d offset;      // from the centre of the pixel, in pixels
    float weight = 1;  // f / (pdf * integral of f): one, or of either sign for mitchell and sinc
};

/// Turns u in (0,1)^2 into offsets by CDF inversion, axis by axis: all five are products. Exact for
/// box and triangle. The others invert the CDF of |f| made linear between 1025 points, and the
/// weight makes up for the difference: it is within 1e-3 of a constant or its negative, but in
/// the few cells where f changes its sign or reaches zero; its mean is one. The integral is over
/// the table's own nodes and midpoints (Simpson's rule).
class FilterSampler {
public:
    /// @param settings  radii and sigma positive; f not zero everywhere.
    explicit FilterSampler(const FilterSettings& settings);
    FilterSample sample(const Vec2d& u) const;

private:
    struct Axis {
        std::vector<double> density;  // |f| at the ends of cells of equal width; empty: by formula
        std::vector<double> cdf;      // of the density, linear in each cell
        double integral = 0;          // of f over that of the density
    };
    static Axis make_axis(const FilterSettings& settings, double radius);
    double sample_axis(const Axis& axis, double radius, double u, double& weight) const;

    FilterSettings settings_;
    Axis x_;
    Axis y_;
};

}  // namespace sunfleck::engine
