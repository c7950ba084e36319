// The scene room: a furnished room lit by the sun through glazed windows.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Half the width and depth of the ground around the room, m: it sets which share of the photon
/// paths of the sun is visible (2.4e-2 in the paper).
inline constexpr double kRoomGroundHalfWidth = 4;

/// About as many triangles as in Table I of Hachisuka and Jensen (2011). Metres, z up.
std::vector<SceneFile> room_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
