// Reader of pbrt-v4 scene files; docs/reference/scenes.md lists what is read and what is
// approximated.
#pragma once

#include "import/pbrt/file_access.h"
#include "scene/description.h"
#include "scene/import_settings.h"

#include <string>

namespace sunfleck::engine {

/// Reads a scene from disk, plain or gzip. Relative names start at its folder.
/// SceneDescription::warnings lists what is not simulated.
/// @throws Error  for what is not a pbrt-v4 scene, or cannot be rendered as one.
SceneDescription read_pbrt(const std::string& path, const ImportSettings& settings = {});

/// Reads a scene from standard input, plain or gzip. Relative names start at the working folder.
/// @throws Error  as read_pbrt().
SceneDescription read_pbrt_input(const ImportSettings& settings = {});

/// Reads a scene from text; SceneDescription::files lists the other files alone.
/// @param path  stands for that of a main file, for messages and relative names.
/// @throws Error  as read_pbrt().
SceneDescription read_pbrt_text(const std::string& text, const std::string& path);
/// @param files  access to other files.
SceneDescription read_pbrt_text(const std::string& text, const std::string& path,
                                const FileAccess& files, const ImportSettings& settings = {});

}  // namespace sunfleck::engine
