// Parameters of media with one value a voxel, and the box that the voxels fill.
#pragma once

#include "import/pbrt/parameters.h"
#include "medium/density_grid.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

/// Returns the place of a parameter, or of the statement if it is not given.
const SourceLocation& place_of(const Statement& medium, std::string_view name);

/// Returns the map of the unit cube to the box between "p0" and "p1", which are in any order
/// (pbrt-v4). @throws Error  for a box of no volume.
Affine box_of(const Statement& medium, const Matrix& to_world);

enum class Negative { is_refused, is_zero };

/// Returns the field of "nx" by "ny" by "nz" values; nothing if the parameter is not given.
/// @throws Error  unless there is a usable value for each voxel.
std::optional<DensityGrid> voxels_of(const Statement& medium, std::string_view name,
                                     const Matrix& to_world, Negative negative);

/// Returns the values of an rgb parameter; none if it is not given. @throws Error  as voxels_of().
std::vector<Vec3d> colours_of(const Statement& medium, std::string_view name);

/// Returns the field of these values, one a voxel.
DensityGrid field_of(const Statement& medium, const std::vector<float>& values,
                     const Matrix& to_world);

}  // namespace sunfleck::engine
