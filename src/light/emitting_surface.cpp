// Points and areas of emitting triangles and disks, and error bounds of all; points of spheres and
// cylinders in emitting_sphere.cpp, of patches in emitting_patch.cpp.
#include "light/emitting_surface.h"

#include "geometry/sweep.h"
#include "geometry/triangle.h"
#include "light/affine_area.h"
#include "math/warp.h"

#include <algorithm>

namespace sunfleck::engine {

namespace {

/// Rounds up: a bound must not lose to the conversion.
float as_bound(double error) {
    return static_cast<float>(error * (1 + 0x1p-20));
}

double turns_of(const Disk& disk) {
    return std::clamp(disk.phi_max / (2 * kPiDouble), 0.0, 1.0);
}

bool is_whole(const Disk& disk) {
    return disk.inner_radius <= 0 && turns_of(disk) > 1 - 1e-9;
}

Vec2d own_point(const Disk& disk, const Vec2d& u) {
    if (is_whole(disk)) return concentric_disc(u) * disk.radius;
    const double inner2 = disk.inner_radius * disk.inner_radius;
    const double radius = std::sqrt(inner2 + u.x * (disk.radius * disk.radius - inner2));
    const SinCos phi = sin_cos_2pi(u.y * turns_of(disk));
    return Vec2d(phi.cos, phi.sin) * radius;
}

double reach(const Sphere& sphere) {
    return std::abs(sphere.radius);
}
double reach(const Disk& disk) {
    return std::abs(disk.radius);
}
double reach(const Cylinder& cylinder) {
    return std::abs(cylinder.radius) + std::max(std::abs(cylinder.z_min), std::abs(cylinder.z_max));
}

/// Rounding to float twice, and the errors of double arithmetic on the shape's own numbers.
template <class Quadric>
double quadric_error(const EmittingQuadric<Quadric>& surface, const SurfaceSample& on) {
    const Affine map(surface.to_world);
    const double size = map.origin.length() + std::sqrt(mean_scale2(map)) * reach(surface.shape);
    return rounding_uncertainty(on.normal, on.position) + 0x1p-44 * std::abs(size);
}

}  // namespace

SurfaceSample sample_surface(const EmittingTriangle& triangle, const Vec2d& u) {
    const Vec2d weight = uniform_triangle(u);
    return {triangle.p0 + triangle.edge1 * weight.x + triangle.edge2 * weight.y, triangle.normal,
            surface_area(triangle)};
}

SurfaceSample sample_surface(const EmittingQuadric<Disk>& disk, const Vec2d& u) {
    const Affine map(disk.to_world);
    const Vec2d point = own_point(disk.shape, u);
    const Vec3d normal = area_vector(map, Vec3d(0, 0, disk.flip ? -1 : 1)).normalized();
    return {map.point({point.x, point.y, disk.shape.height}), normal, surface_area(disk)};
}

Vec2d surface_square(const EmittingTriangle& triangle, const Vec3d& on, const Vec3d&) {
    const Vec3d area = triangle.edge1.cross(triangle.edge2);
    const Vec3d from = on - triangle.p0;
    return triangle_to_square({from.cross(triangle.edge2).dot(area) / area.length2(),
                               triangle.edge1.cross(from).dot(area) / area.length2()});
}

Vec2d surface_square(const EmittingQuadric<Disk>& disk, const Vec3d& on, const Vec3d&) {
    const Disk& shape = disk.shape;
    const Vec3d own = Affine(disk.to_world).inverse().point(on);
    if (is_whole(shape)) return disc_to_square(Vec2d(own.x, own.y) / shape.radius);
    const double inner2 = shape.inner_radius * shape.inner_radius;
    return {(own.x * own.x + own.y * own.y - inner2) / (shape.radius * shape.radius - inner2),
            azimuth(own.x, own.y) / (kFullCircle * turns_of(shape))};
}

double surface_spread(const EmittingTriangle& triangle, const Vec3d&, const Vec3d&) {
    return surface_area(triangle);
}

double surface_spread(const EmittingQuadric<Disk>& disk, const Vec3d&, const Vec3d&) {
    return surface_area(disk);
}

double surface_area(const EmittingTriangle& triangle) {
    return triangle.edge1.cross(triangle.edge2).length() / 2;
}

float surface_error(const EmittingTriangle& triangle, const SurfaceSample& on) {
    const Triangle corners{
        {triangle.p0, triangle.p0 + triangle.edge1, triangle.p0 + triangle.edge2}};
    return as_bound(plane_uncertainty(corners, corners.area_vector(), on.position) +
                    rounding_uncertainty(on.normal, on.position));
}

float surface_error(const EmittingPatch& patch, const SurfaceSample& on) {
    double size = 0;
    for (const Vec3d& p : patch.surface.corner) size = std::max(size, p.length());
    return as_bound(rounding_uncertainty(on.normal, on.position) + 0x1p-44 * size);
}

float surface_error(const EmittingQuadric<Cylinder>& cylinder, const SurfaceSample& on) {
    return as_bound(quadric_error(cylinder, on));
}

float surface_error(const EmittingQuadric<Sphere>& sphere, const SurfaceSample& on) {
    return as_bound(quadric_error(sphere, on));
}

float surface_error(const EmittingQuadric<Disk>& disk, const SurfaceSample& on) {
    return as_bound(quadric_error(disk, on));
}

}  // namespace sunfleck::engine
