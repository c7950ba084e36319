// The scenes useful-light and useless-light: a room lit by a hidden lamp, by night and by day.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Unit: metres; z is up. In useless-light a sun of a hundred times the lamp's power enters through
/// a slit in the roof of the next room. No visible surface sees lamp or sun.
std::vector<SceneFile> lamp_room_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
