// The share of an emitting surface that is there: its alpha, as a factor of what light samples and
// photons bring from it. Rays meet it by chance (geometry/cover.h), with the same mean.
#pragma once

#include "geometry/geometry.h"
#include "light/surface_uv.h"

namespace sunfleck::engine {

class PartialEmitter {
public:
    /// @param cover  as the shape has it; not null.
    PartialEmitter(Cover cover, const CornerUvs& uvs, const EmittingSurface& surface);

    /// At a point of the surface, in [0,1].
    /// @param normal  of the surface there, unit, either side.
    float at(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) const;
    /// Over the surface, by midpoints, above zero: what the power is multiplied by.
    double mean() const { return mean_; }

private:
    Cover cover_;
    CornerUvs uvs_;
    double mean_ = 0;
};

}  // namespace sunfleck::engine
