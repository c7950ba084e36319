// The writer of pbrt-v4 scenes: a description as text, with its meshes and pictures as files.
//
// Source of the format: pbrt-v4's file format; numbers and scales as import/pbrt reads them.
#pragma once

#include "export/exported_scene.h"
#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

/// Returns the files of a scene that pbrt-v4 renders alike, the main one last. What cannot be said
/// there is told once a kind, with what is written instead.
/// @param scene  as it was read, before Scene is made of it; it must outlive the files.
/// @param name  of the main file, without a folder, such as cup.pbrt; other files are in a folder
/// cup-files beside it.
ExportedScene pbrt_scene(const SceneDescription& scene, const std::string& name);

}  // namespace sunfleck::engine
