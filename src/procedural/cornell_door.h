// The scene cornell-door: a Cornell box that gets its light through a door ajar.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// By how much the door stands open, in turns: the one number that sets which share of the photon
/// paths from the lamp next door is visible (1.8e-2 in the paper).
inline constexpr double kDoorOpen = 0.14;

/// 730 triangles, as in Table I of Hachisuka and Jensen (2011). Centimetres, z up.
std::vector<SceneFile> cornell_door_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
