// Intersection, surface, bounds and area of cylinders.
#include "geometry/cylinder.h"

#include "geometry/quadrature.h"
#include "geometry/sweep.h"

#include <cmath>

namespace sunfleck::engine {

/// From the middle of the chord that the circle cuts off, as for spheres (sphere.cpp), seen along
/// the axis.
Crossings Cylinder::crossings(const Vec3d& origin, const Vec3d& direction) const {
    const double length2 = direction.x * direction.x + direction.y * direction.y;
    if (!(length2 > 0)) return {};
    const double middle = -(origin.x * direction.x + origin.y * direction.y) / length2;
    const double x = origin.x + direction.x * middle;
    const double y = origin.y + direction.y * middle;
    const double depth = radius * radius - (x * x + y * y);
    if (!(depth >= 0)) return {};
    const double half = std::sqrt(depth / length2);
    Crossings result{{middle - half, middle + half}, {}};
    const Sweep sweep(phi_max);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3d p = origin + direction * result.t[i];
        result.on[i] = p.z >= z_min && p.z <= z_max && sweep.contains(p.x, p.y);
    }
    return result;
}

/// The parametrisation of pbrt-v4: u the azimuth, v the height.
LocalSurface Cylinder::at(const Vec3d& near, const Vec3d&) const {
    const double distance = std::sqrt(near.x * near.x + near.y * near.y);
    const Vec3d normal =
        distance > 0 ? Vec3d(near.x / distance, near.y / distance, 0) : Vec3d(1, 0, 0);
    const double turn = Sweep(phi_max).angle();
    const double u = turn > 0 ? azimuth(normal.x, normal.y) / turn : 0;
    const double v = z_max > z_min ? (near.z - z_min) / (z_max - z_min) : 0;
    const double size = std::abs(radius);
    return {{normal.x * size, normal.y * size, near.z},
            normal,
            Vec3d(-normal.y, normal.x, 0) * (size * (turn > 0 ? turn : 1)),
            {static_cast<float>(std::min(u, 1.0)), static_cast<float>(v)}};
}

Bounds Cylinder::bounds(const Affine& map) const {
    Vec3d half;
    for (int i = 0; i < 3; ++i)
        half[i] = std::abs(radius) * std::sqrt(map.x[i] * map.x[i] + map.y[i] * map.y[i]);
    Bounds box;
    for (const double z : {z_min, z_max}) {
        const Vec3d center = map.point({0, 0, z});
        box.extend(center - half);
        box.extend(center + half);
    }
    return box;
}

/// A strip along the axis keeps its width and height but for the length of the image of
/// (tangent x axis): the same all around where the map takes circles to circles at right angles
/// to the axis.
double Cylinder::area(const Affine& map) const {
    const double turn = Sweep(phi_max).angle();
    const double flat = std::abs(radius) * turn * std::abs(z_max - z_min);
    const double xx = map.x.dot(map.x);
    const double zz = map.z.dot(map.z);
    const double skew =
        std::max({std::abs(map.y.dot(map.y) - xx) / xx, std::abs(map.x.dot(map.y)) / xx,
                  std::abs(map.x.dot(map.z)) / std::sqrt(xx * zz),
                  std::abs(map.y.dot(map.z)) / std::sqrt(xx * zz)});
    if (skew < 1e-12) return flat * std::sqrt(xx * zz);
    const auto stretch = [&](double phi, double) {
        const SinCos p = sin_cos(phi);
        return (map.y * p.cos - map.x * p.sin).cross(map.z).length();
    };
    return flat / turn * integrate_rectangle(stretch, {0, turn}, {0, 1}, 1e-8);
}

}  // namespace sunfleck::engine
