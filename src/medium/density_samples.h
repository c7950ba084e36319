// Densities of boxes from one value per sample, x first.
#pragma once

#include "medium/density_grid.h"

#include <span>

namespace sunfleck::engine {

/// Returns the density of a box of equal parts with a value at the centre of each. Beyond the outer
/// centres it falls towards zero, which it would reach half a part outside of the box (pbrt-v4).
/// @param values  finite, 0 or more; one a part.
/// @param box_to_world  from the unit cube; invertible.
DensityGrid density_of_parts(std::span<const float> values, const Voxel& parts,
                             const Affine& box_to_world);

/// Returns the density of a box with values at its corners and at the borders of equal parts.
/// @param values  as above, one more along each axis than there are parts.
DensityGrid density_of_points(std::span<const float> values, const Voxel& parts,
                              const Affine& box_to_world);

}  // namespace sunfleck::engine
