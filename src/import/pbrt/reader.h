// Reads pbrt-v4 scene files. What is read, and what stands in for the rest:
// docs/reference/scenes.md.
#pragma once

#include "import/pbrt/file_access.h"
#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

/// Reads a scene from disk, plain or packed by gzip. Files named in it are found from its folder.
/// What is not simulated is told in SceneDescription::warnings.
/// @throws Error for what is no pbrt-v4 scene, or cannot be rendered as one.
SceneDescription read_pbrt(const std::string& path);

/// Reads a scene from standard input, plain or packed by gzip. Files named in it are found from the
/// working folder. @throws Error as read_pbrt() does.
SceneDescription read_pbrt_input();

/// Reads a scene from text. @param path  the name of the main file: in messages, and for the
/// folder of the files that the text names. @throws Error as read_pbrt() does.
SceneDescription read_pbrt_text(const std::string& text, const std::string& path);
/// @param files  how other files are read, if they are.
SceneDescription read_pbrt_text(const std::string& text, const std::string& path,
                                const FileAccess& files);

}  // namespace sunfleck::engine
