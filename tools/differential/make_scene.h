// Makes a random small scene that has the chosen features.
#pragma once

#include "differential/features.h"
#include "differential/scene_text.h"

#include <cstdint>
#include <string>

namespace sunfleck::engine::differential {

/// The same table, choice, seed and number give the same scene. Its files are those of write_files.
SceneText make_scene(const FeatureTable& table, const Choice& choice, std::uint64_t seed,
                     std::uint32_t number);

/// Writes what the scenes name (pictures, a mesh, a spectrum) to the folder "files" in `folder`.
/// @throws Error if a file cannot be written.
void write_files(const std::string& folder);

/// Whether paths that start at the camera find all light: light without an extent is found only
/// where no smooth surface lies between it and what it lights.
bool is_found_by_path(const FeatureTable& table, const Choice& choice);

}  // namespace sunfleck::engine::differential
