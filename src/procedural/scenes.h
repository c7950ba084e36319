// Catalogue of procedural scenes, as pbrt-v4 files that pbrt-v4 itself can render.
//
// In:  a name. Out: the bytes of the files, the same on every machine.
#pragma once

#include "procedural/scene_file.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Returns all scenes in the order of listing.
std::vector<ProceduralScene> procedural_scenes();

/// Returns the files of one scene. The first is NAME.pbrt; it names the others relative to itself
/// (geometry/*.ply, binary). Files of one name have the same bytes in all scenes, so one folder can
/// hold all scenes.
/// @throws Error  for an unknown name; the message lists all names.
std::vector<SceneFile> make_scene(const std::string& name);

}  // namespace sunfleck::engine
