// DensityGrid: a density that is linear along each axis between the points of a lattice.
//
// In:  values at the points, the box that they fill and its place. Out: the density at a point, and
// its integral along a way, exact but for rounding: within a cell the density along a line is a
// cubic polynomial, which two points by Gauss and Legendre integrate. No random numbers. Equations:
// docs/method/media-fields.md.
#pragma once

#include "geometry/affine.h"
#include "geometry/bounds.h"
#include "geometry/ray.h"
#include "medium/lattice_walk.h"

#include <memory>

namespace sunfleck::engine {

class DensityGrid {
public:
    /// @param bounds  in the lattice, whose points are integers: within 0 and the number of cells.
    /// Outside the density is zero.
    /// @param to_world  from the lattice; invertible.
    DensityGrid(std::shared_ptr<const VoxelBlocks> voxels, const Bounds& bounds,
                const Affine& to_world);

    float at(const Vec3& point) const;
    /// Returns the integral of the density along a way. Its length may be infinite.
    float amount(const Ray& way) const;
    /// Inverts amount(): returns the greatest distance before which lies no more than the amount,
    /// or where the last of the density ends, if all of it is less.
    float distance_at(const Ray& way, float amount) const;

    float greatest() const { return voxels_->greatest(); }
    /// Returns the mean over the box.
    float mean() const;
    /// Returns the same density elsewhere in the world.
    DensityGrid moved(const Vec3d& by) const;
    /// Returns the same density on the whole lattice, also where it ends within a cell.
    DensityGrid whole() const;
    const VoxelBlocks& voxels() const { return *voxels_; }
    /// Returns the map from the lattice.
    const Affine& to_world() const { return to_world_; }
    const Affine& to_grid() const { return to_grid_; }

private:
    LatticeLine line_of(const Ray& way) const;

    std::shared_ptr<const VoxelBlocks> voxels_;
    Bounds bounds_;
    Affine to_world_;
    Affine to_grid_;
};

}  // namespace sunfleck::engine
