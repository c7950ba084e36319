// Writing of the files of a scene: all of them or none.
#pragma once

#include "export/exported_scene.h"

#include <filesystem>
#include <vector>

namespace sunfleck::engine {

/// Writes files below a folder, which is made where there is none; each appears complete or not at
/// all. Files that are there with the same bytes stay as they are. If one cannot be written, those
/// that were new are removed again.
/// @param replaces  files that differ.
/// @throws Error  before anything is written, if another file stands where one is to be written and
/// `replaces` is false.
void write_scene_files(const std::filesystem::path& folder, const std::vector<ExportedFile>& files,
                       bool replaces);

}  // namespace sunfleck::engine
