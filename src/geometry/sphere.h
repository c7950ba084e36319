// A sphere around the origin of its frame, or a part of it; intersected exactly, in double.
#pragma once

#include "geometry/local_surface.h"

namespace sunfleck::engine {

/// The part with z in [z_min, z_max] and azimuth in [0, phi_max]. The normal points outwards.
struct Sphere {
    double radius = 1;
    double z_min = -1;
    double z_max = 1;
    double phi_max = 6.283185307179586;  // radians

    Crossings crossings(const Vec3d& origin, const Vec3d& direction) const;
    LocalSurface at(const Vec3d& near, const Vec3d& direction) const;
    /// Of the whole sphere; tight.
    Bounds bounds(const Affine& map) const;
    /// A closed form under rotations and uniform scales, else quadrature.
    double area(const Affine& map) const;
};

static_assert(ExactShape<Sphere> && HasArea<Sphere>);

}  // namespace sunfleck::engine
