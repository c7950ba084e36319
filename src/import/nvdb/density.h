// Densities from NanoVDB files (.nvdb).
#pragma once

#include "medium/density_grid.h"
#include "sunfleck/error.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Returns whether a file has a grid of that name. @throws Error  as nvdb_density().
bool has_nvdb_grid(std::string_view file, const std::string& grid, const std::string& name);

/// Returns the density of a grid of floats, linear between its voxels' values.
/// @param to_world  from the grid's own world.
/// @param name  of the file, for errors.
/// @throws Error  for a file that is none, is damaged or lacks the grid, for grids of other types
/// and for negative values.
DensityGrid nvdb_density(std::string_view file, const std::string& grid, const Matrix& to_world,
                         const std::string& name);

}  // namespace sunfleck::engine
