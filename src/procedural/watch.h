// The scene watch: a pocket watch with an open lid, lit by sun and sky.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Half the side of the square table in mm. It sets the visible fraction (3.7e-3 in the paper, all
/// light by photons), because sun and sky emit towards the whole table.
inline constexpr double kWatchTableHalfWidth = 850;

/// Returns about as many triangles as in Table I of Hachisuka and Jensen (2011). Unit: millimetres;
/// z is up.
std::vector<SceneFile> watch_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
