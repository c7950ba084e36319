// Reader of parts: OBJ, STL and PLY files alone become scenes, with a ground and a view.
#pragma once

#include "scene/description.h"
#include "scene/import_settings.h"

#include <string>

namespace sunfleck::engine {

/// Returns whether a path ends as parts do: .obj, .stl, .ply, in any case.
bool is_part(const std::string& path);

/// Returns the axis that points up: as the settings say, else z for STL and y for OBJ and PLY.
UpAxis up_of_part(const std::string& path, const ImportSettings& settings);

/// Reads a part. The world has the axes of the file, in metres; warnings tell what the file leaves
/// open and what is used. Lights are those of the file alone.
/// @throws Error  for files that cannot be read, and for all that are missing at once.
SceneDescription read_part(const std::string& path, const ImportSettings& settings);

}  // namespace sunfleck::engine
