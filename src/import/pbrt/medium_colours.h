// rgbgrid: a medium of a colour per voxel, as one of their mean colour whose density varies.
#pragma once

#include "import/pbrt/import_log.h"
#include "import/pbrt/parameters.h"
#include "scene/media.h"

namespace sunfleck::engine {

/// Returns the medium without "scale" and "g", and warns of what is not simulated: its density, and
/// what it emits, are those of each voxel; its colours are their means.
/// @param to_world  the matrix of the statement.
/// @throws Error  unless there is a usable colour for each voxel.
Medium medium_of_colours(const Statement& medium, const Matrix& to_world, ImportLog& log);

}  // namespace sunfleck::engine
