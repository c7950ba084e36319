// A cylinder around the z axis of its frame, open at both ends, or a sector of it; intersected
// exactly, in double.
#pragma once

#include "geometry/local_surface.h"

namespace sunfleck::engine {

/// The part with z in [z_min, z_max] and azimuth in [0, phi_max]. The normal points outwards.
struct Cylinder {
    double radius = 1;
    double z_min = -1;
    double z_max = 1;
    double phi_max = 6.283185307179586;  // radians

    Crossings crossings(const Vec3d& origin, const Vec3d& direction) const;
    LocalSurface at(const Vec3d& near, const Vec3d& direction) const;
    /// Of the whole turn; tight.
    Bounds bounds(const Affine& map) const;
    /// A closed form where the map keeps circles, else quadrature.
    double area(const Affine& map) const;
};

static_assert(ExactShape<Cylinder> && HasArea<Cylinder>);

}  // namespace sunfleck::engine
