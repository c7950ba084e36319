// The scene magnifier: a printed page under a reading glass, lit by a lamp in a globe of glass.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Radius of the emitter in the lamp in cm: the smaller, the harder for camera paths, which must
/// hit it through the glass of the lamp.
inline constexpr double kGlowRadius = 0.7;

/// Returns a scene of 640 x 480 pixels. Light passes glass, and much of what it illuminates is seen
/// through a lens, in a mirror, or in a glass ball. Unit: centimetres; z is up.
std::vector<SceneFile> magnifier_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
