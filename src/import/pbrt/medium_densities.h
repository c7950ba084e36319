// Densities of media that vary in space: uniformgrid, nanovdb and cloud.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/scene_files.h"
#include "medium/density.h"

#include <memory>

namespace sunfleck::engine {

/// Returns the density of a MakeNamedMedium; null if the medium is alike everywhere.
/// @param to_world  the matrix of the statement.
/// @throws Error  for values that cannot be, and for a file that cannot be used.
std::shared_ptr<const Density> density_of(const Statement& medium, const Matrix& to_world,
                                          SceneFiles& files);

}  // namespace sunfleck::engine
