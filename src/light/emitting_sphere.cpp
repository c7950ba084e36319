// Sampling of emitting spheres and cylinders, full or partial, under any matrix; visible caps.
#include "geometry/sweep.h"
#include "light/affine_area.h"
#include "light/emitting_surface.h"
#include "math/warp.h"

#include <algorithm>

namespace sunfleck::engine {

namespace {

/// The existing part of a sphere: heights over the radius, and azimuths.
struct Zone {
    double low;
    double high;
    double circle_fraction;  // phi_max / (2 pi)

    explicit Zone(const Sphere& s)
        : low(std::clamp(std::min(s.z_min, s.z_max) / std::abs(s.radius), -1.0, 1.0)),
          high(std::clamp(std::max(s.z_min, s.z_max) / std::abs(s.radius), -1.0, 1.0)),
          circle_fraction(std::clamp(s.phi_max / (2 * kPiDouble), 0.0, 1.0)) {}

    bool is_whole() const { return low <= -1 && high >= 1 && circle_fraction > 1 - 1e-9; }
};

double own_area(const Sphere& sphere) {
    const Zone zone(sphere);
    return sphere.radius * sphere.radius * (zone.high - zone.low) * zone.circle_fraction * 2 *
           kPiDouble;
}

double own_area(const Cylinder& cylinder) {
    const double circle_fraction = std::clamp(cylinder.phi_max / (2 * kPiDouble), 0.0, 1.0);
    return std::abs(cylinder.radius * (cylinder.z_max - cylinder.z_min)) * circle_fraction * 2 *
           kPiDouble;
}

/// Returns the sample at a surface point with unit normal `own` in the shape's frame.
template <class Quadric>
SurfaceSample sample_at(const EmittingQuadric<Quadric>& quadric, const Vec3d& point,
                        const Vec3d& own) {
    const Affine map(quadric.to_world);
    const Vec3d area = area_vector(map, own);
    const double ratio = area.length();
    const double side = quadric.flip ? -1 : 1;
    return {map.point(point), area * (side / ratio), own_area(quadric.shape) * ratio};
}

template <class Quadric>
double spread_at(const EmittingQuadric<Quadric>& quadric, const Vec3d& normal) {
    return own_area(quadric.shape) * area_ratio_of_image(Affine(quadric.to_world), normal);
}

/// Returns the outward unit normal in the sphere's frame.
Vec3d own_normal(const Sphere& sphere, const Vec2d& u) {
    const Zone zone(sphere);
    if (zone.is_whole()) return uniform_sphere(u);
    const double z = zone.low + u.x * (zone.high - zone.low);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const SinCos phi = sin_cos_2pi(u.y * zone.circle_fraction);
    return {r * phi.cos, r * phi.sin, z};
}

}  // namespace

SurfaceSample sample_surface(const EmittingQuadric<Sphere>& sphere, const Vec2d& u) {
    const Vec3d own = own_normal(sphere.shape, u);
    return sample_at(sphere, own * std::abs(sphere.shape.radius), own);
}

SurfaceSample sample_surface(const EmittingQuadric<Cylinder>& cylinder, const Vec2d& u) {
    const Cylinder& c = cylinder.shape;
    const SinCos phi = sin_cos_2pi(u.y * std::clamp(c.phi_max / (2 * kPiDouble), 0.0, 1.0));
    const Vec3d own(phi.cos, phi.sin, 0);
    const Vec3d height(0, 0, c.z_min + u.x * (c.z_max - c.z_min));
    return sample_at(cylinder, own * std::abs(c.radius) + height, own);
}

Vec2d surface_square(const EmittingQuadric<Sphere>& sphere, const Vec3d& on, const Vec3d&) {
    const Zone zone(sphere.shape);
    const Vec3d own = Affine(sphere.to_world).inverse().point(on).normalized();
    if (zone.is_whole()) return sphere_to_square(own);
    return {(own.z - zone.low) / (zone.high - zone.low),
            azimuth(own.x, own.y) / (kFullCircle * zone.circle_fraction)};
}

Vec2d surface_square(const EmittingQuadric<Cylinder>& cylinder, const Vec3d& on, const Vec3d&) {
    const Cylinder& c = cylinder.shape;
    const Vec3d own = Affine(cylinder.to_world).inverse().point(on);
    const double circle_fraction = std::clamp(c.phi_max / (2 * kPiDouble), 0.0, 1.0);
    return {(own.z - c.z_min) / (c.z_max - c.z_min),
            azimuth(own.x, own.y) / (kFullCircle * circle_fraction)};
}

double surface_spread(const EmittingQuadric<Sphere>& sphere, const Vec3d&, const Vec3d& normal) {
    return spread_at(sphere, normal);
}

double surface_spread(const EmittingQuadric<Cylinder>& cylinder, const Vec3d&,
                      const Vec3d& normal) {
    return spread_at(cylinder, normal);
}

std::optional<VisibleCap> visible_cap(const EmittingQuadric<Sphere>& sphere, const Vec3d& point) {
    const Affine map(sphere.to_world);
    if (!Zone(sphere.shape).is_whole() || !is_similarity(map)) return {};
    const Vec3d to_center = map.origin - point;
    const double radius2 = sphere.shape.radius * sphere.shape.radius * mean_scale2(map);
    const double distance2 = to_center.length2();
    const double distance = std::sqrt(distance2);
    // A point of the sphere itself, rounded to floats, sees no cap.
    const Vec3d& o = map.origin;
    const double rounding = 0x1p-21 * (std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
    if (!(distance > std::sqrt(radius2) * (1 + 1e-4) + rounding)) return {};
    const double sine2 = radius2 / distance2;
    return VisibleCap{to_center / distance, distance, std::sqrt(radius2),
                      sine2 / (1 + std::sqrt(1 - sine2))};
}

double way_within(const EmittingQuadric<Sphere>& sphere, const Vec3d& on, const Vec3d& direction) {
    const Affine map(sphere.to_world);
    const double inwards = (map.origin - on).dot(direction);
    if (!(inwards > 0) || !Zone(sphere.shape).is_whole() || !is_similarity(map))
        return std::numeric_limits<double>::infinity();
    return 2 * inwards;
}

}  // namespace sunfleck::engine
