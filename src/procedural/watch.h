// The scene watch: a pocket watch with an open lid, lit by sun and sky.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Half the side of the square table, mm: it sets which share of the photon paths is visible
/// (3.7e-3 in the paper, all light by photons): sun and sky send them towards the whole table.
inline constexpr double kWatchTableHalfWidth = 850;

/// About as many triangles as in Table I of Hachisuka and Jensen (2011). Millimetres, z up.
std::vector<SceneFile> watch_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
