// The scene diamond: a brilliant lying in the sun, with its coloured caustics.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Returns the scene file, the stone and the sky. Unit: millimetres; z is up.
std::vector<SceneFile> diamond_scene();

/// Returns the stone lying on one facet of its pavilion, a hundredth of a millimetre above z = 0.
Mesh lying_brilliant();

}  // namespace sunfleck::engine
