// PartialEmitter: alpha of an emitting surface, as a factor of its light samples and photons. Rays
// apply it as an alpha test (geometry/cover.h), with the same mean.
#pragma once

#include "geometry/geometry.h"
#include "light/surface_uv.h"

namespace sunfleck::engine {

class PartialEmitter {
public:
    /// @param cover  alpha of the shape; not null.
    PartialEmitter(Cover cover, CornerUvs uvs, const EmittingSurface& surface);

    /// Returns alpha at a point of the surface, in [0,1].
    /// @param normal  of the surface there, unit, either side.
    float at(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) const;
    /// Returns the mean of alpha over the surface by midpoints, above zero; a factor of the power.
    double mean() const { return mean_; }

private:
    Cover cover_;
    CornerUvs uvs_;
    double mean_ = 0;
};

}  // namespace sunfleck::engine
