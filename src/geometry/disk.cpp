// Intersection, surface, bounds and area of disks.
#include "geometry/disk.h"

#include "geometry/sweep.h"

#include <cmath>

namespace sunfleck::engine {

Crossings Disk::crossings(const Vec3d& origin, const Vec3d& direction) const {
    if (direction.z == 0) return {};
    const double t = (height - origin.z) / direction.z;
    const double x = origin.x + t * direction.x;
    const double y = origin.y + t * direction.y;
    const double distance2 = x * x + y * y;
    const bool in_ring = distance2 <= radius * radius && distance2 >= inner_radius * inner_radius;
    return {{t, t}, {in_ring && Sweep(phi_max).contains(x, y), false}};
}

/// The parametrisation of pbrt-v4: u the azimuth, v one at the inner rim and zero at the outer.
LocalSurface Disk::at(const Vec3d& near, const Vec3d&) const {
    const double turn = Sweep(phi_max).angle();
    const double distance = std::sqrt(near.x * near.x + near.y * near.y);
    const double u = turn > 0 ? azimuth(near.x, near.y) / turn : 0;
    const double v = (radius - distance) / (radius - inner_radius);
    Vec3d tangent = Vec3d(-near.y, near.x, 0) * turn;
    if (tangent == Vec3d(0)) tangent = {0, radius, 0};
    const Vec3d outwards = distance > 0 ? Vec3d(near.x, near.y, 0) / distance : Vec3d(1, 0, 0);
    const Vec3d cotangent = outwards * (inner_radius - radius);
    return {{near.x, near.y, height},
            {0, 0, 1},
            tangent,
            {static_cast<float>(std::min(u, 1.0)), static_cast<float>(v)},
            cotangent};
}

Bounds Disk::bounds(const Affine& map) const {
    const Vec3d center = map.point({0, 0, height});
    Vec3d half;
    for (int i = 0; i < 3; ++i)
        half[i] = std::abs(radius) * std::sqrt(map.x[i] * map.x[i] + map.y[i] * map.y[i]);
    return {center - half, center + half};
}

double Disk::area(const Affine& map) const {
    const double ring = radius * radius - inner_radius * inner_radius;
    return std::abs(0.5 * Sweep(phi_max).angle() * ring) * map.x.cross(map.y).length();
}

}  // namespace sunfleck::engine
