// The catalogue of procedural scenes: pbrt-v4 files that pbrt-v4 itself can render.
//
// In:  a name. Out: the bytes of the files, the same on every machine.
#pragma once

#include "procedural/scene_file.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// All of them, in the order of listing.
std::vector<ProceduralScene> procedural_scenes();

/// The files of one scene. The first is NAME.pbrt; it names the others relative to itself
/// (geometry/*.ply, binary). Files of one name have the same bytes in all scenes: one folder can
/// hold them all.
/// @throws Error for a name that procedural_scenes() does not have; the message lists them.
std::vector<SceneFile> make_scene(const std::string& name);

}  // namespace sunfleck::engine
