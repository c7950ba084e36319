// A disk in the plane z = height of its frame, or a sector of a ring; the normal is +z.
#pragma once

#include "geometry/local_surface.h"

namespace sunfleck::engine {

/// Points with distance from the axis in [inner_radius, radius] and azimuth in [0, phi_max].
struct Disk {
    double height = 0;
    double radius = 1;
    double inner_radius = 0;
    double phi_max = 6.283185307179586;  // radians

    /// There is one at most: the first.
    Crossings crossings(const Vec3d& origin, const Vec3d& direction) const;
    LocalSurface at(const Vec3d& near, const Vec3d& direction) const;
    /// Of the whole disk; tight.
    Bounds bounds(const Affine& map) const;
    /// A closed form under every map.
    double area(const Affine& map) const;
};

static_assert(ExactShape<Disk> && HasArea<Disk>);

}  // namespace sunfleck::engine
