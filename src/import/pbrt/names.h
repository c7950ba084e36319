// Names of shapes and materials, by which mattes tell them apart.
#pragma once

#include "import/pbrt/parameters.h"

#include <string>

namespace sunfleck::engine {

/// Returns the name of a shape: that of its file without its ending, or its type and place.
std::string shape_name(const Statement& statement);

/// Returns the name of a material that has none in the scene: its type and place.
std::string material_name(const Statement& statement);

}  // namespace sunfleck::engine
