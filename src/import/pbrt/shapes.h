// Conversion of Shape statements, with material and emission of the graphics state.
#pragma once

#include "import/pbrt/parameters.h"

namespace sunfleck::engine {

struct Reading;

/// Adds the shape to the world, or to the open object.
/// @throws Error  for an unknown type, and for invalid parameters.
void add_shape(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
