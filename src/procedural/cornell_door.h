// The scene cornell-door: a Cornell box that gets its light through a door ajar.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Opening of the door as a fraction of a revolution. It sets the fraction of visible photon paths
/// from the lamp in the other room (1.8e-2 in the paper).
inline constexpr double kDoorOpen = 0.14;

/// Returns 730 triangles, as in Table I of Hachisuka and Jensen (2011). Unit: centimetres; z is up.
std::vector<SceneFile> cornell_door_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
