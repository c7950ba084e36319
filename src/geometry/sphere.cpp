// Intersection, surface, bounds and area of spheres.
#include "geometry/sphere.h"

#include "geometry/quadrature.h"
#include "geometry/sweep.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

/// Heights of the part that is there, in units of the radius, in [-1, 1].
struct Heights {
    double low;
    double high;

    explicit Heights(const Sphere& s)
        : low(std::clamp(std::min(s.z_min, s.z_max) / std::abs(s.radius), -1.0, 1.0)),
          high(std::clamp(std::max(s.z_min, s.z_max) / std::abs(s.radius), -1.0, 1.0)) {}

    /// The poles belong to a sphere that is not cut, whatever the rounding.
    bool contains(double z) const { return (low <= -1 || z >= low) && (high >= 1 || z <= high); }
};

}  // namespace

/// From the middle of the chord, half its length either way: the square root is that of the
/// distance below the surface, not a difference of large squares.
/// Source: Haines et al., Precision Improvements for Ray/Sphere Intersection (Ray Tracing Gems).
Crossings Sphere::crossings(const Vec3d& origin, const Vec3d& direction) const {
    const double length2 = direction.dot(direction);
    const double middle = -origin.dot(direction) / length2;
    const Vec3d nearest = origin + direction * middle;
    const double depth = radius * radius - nearest.dot(nearest);
    if (!(depth >= 0)) return {{middle, middle}, {}};
    const double half = std::sqrt(depth / length2);
    Crossings result{{middle - half, middle + half}, {}};
    const Heights heights(*this);
    const Sweep sweep(phi_max);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3d p = origin + direction * result.t[i];
        result.on[i] = heights.contains(p.z / std::abs(radius)) && sweep.contains(p.x, p.y);
    }
    return result;
}

/// The parametrisation of pbrt-v4: u the azimuth, v the angle from the pole, zero at z_min.
LocalSurface Sphere::at(const Vec3d& near, const Vec3d&) const {
    const double length = near.length();
    const Vec3d normal = length > 0 ? near / length : Vec3d(0, 0, 1);
    const Heights heights(*this);
    const double turn = Sweep(phi_max).angle();
    const auto from_pole = [](double z) {
        return std::acos(static_cast<float>(std::clamp(z, -1.0, 1.0)));
    };
    const float at_low = from_pole(heights.low);
    const float at_high = from_pole(heights.high);
    const double u = turn > 0 ? azimuth(normal.x, normal.y) / turn : 0;
    const float v = at_high == at_low ? 0 : (from_pole(normal.z) - at_low) / (at_high - at_low);
    const Vec3d position = normal * std::abs(radius);
    Vec3d tangent = Vec3d(-position.y, position.x, 0) * turn;
    if (tangent == Vec3d(0)) tangent = {0, std::abs(radius), 0};
    // v falls towards the pole: dp/dv is along the meridian, by the sweep of angles.
    const double across = std::sqrt(position.x * position.x + position.y * position.y);
    const Vec3d outwards = across > 0 ? Vec3d(position.x, position.y, 0) / across : Vec3d(1, 0, 0);
    const double sweep = double{at_high} - double{at_low};
    const Vec3d cotangent = (outwards * position.z - Vec3d(0, 0, across)) * sweep;
    return {position, normal, tangent, {static_cast<float>(std::min(u, 1.0)), v}, cotangent};
}

Bounds Sphere::bounds(const Affine& map) const {
    Vec3d half;
    for (int i = 0; i < 3; ++i) {
        const Vec3d column(map.x[i], map.y[i], map.z[i]);
        half[i] = std::abs(radius) * std::sqrt(column.dot(column));
    }
    return {map.origin - half, map.origin + half};
}

/// Archimedes: dA = r^2 dphi dcos(theta) on the sphere; the map stretches an element with normal
/// n by the length of its cofactor matrix times n.
double Sphere::area(const Affine& map) const {
    const Heights heights(*this);
    const double turn = Sweep(phi_max).angle();
    const double flat = radius * radius * turn * (heights.high - heights.low);
    const Placement placement(map);
    const std::array<Vec3d, 3> axes{map.x, map.y, map.z};
    const double scale2 = map.x.dot(map.x);
    bool is_similarity = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d& next = axes[(i + 1) % 3];
        is_similarity = is_similarity && std::abs(axes[i].dot(axes[i]) - scale2) < 1e-12 * scale2 &&
                        std::abs(axes[i].dot(next)) < 1e-12 * scale2;
    }
    if (is_similarity) return flat * scale2;
    const auto stretch = [&](double theta, double phi) {
        const SinCos t = sin_cos(theta);
        const SinCos p = sin_cos(phi);
        return placement.normal({t.sin * p.cos, t.sin * p.sin, t.cos}).length() * t.sin;
    };
    const double from = arc_cosine(heights.high);
    const double to = arc_cosine(heights.low);
    return radius * radius * integrate_rectangle(stretch, {from, to}, {0, turn}, 1e-8);
}

}  // namespace sunfleck::engine
