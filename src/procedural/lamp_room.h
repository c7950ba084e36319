// The scenes useful-light and useless-light: a room lit by a hidden lamp, by night and by day.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Metres, z up. Of the two, useless-light has a sun of a hundred times the lamp's power, which
/// comes in through one slit in the roof of the next room. No surface in view sees lamp or sun.
std::vector<SceneFile> lamp_room_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
