// The scene magnifier: a printed page under a reading glass, lit by a lamp in a globe of glass.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Radius of the glowing body in the lamp, cm: the smaller, the harder for paths from the eye,
/// which must meet it through the glass of the lamp.
inline constexpr double kGlowRadius = 0.7;

/// 640 x 480. Light comes through glass, and much of what it falls on is seen through a lens, in a
/// mirror, or in a ball of glass. Centimetres, z up.
std::vector<SceneFile> magnifier_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
