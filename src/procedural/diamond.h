// The scene diamond: a brilliant lying in the sun, which it throws about in colours.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// The scene's file, the stone and the sky. Millimetres, z up.
std::vector<SceneFile> diamond_scene();

/// The stone as it lies: on one facet of its pavilion, a hundredth of a millimetre above z = 0.
Mesh lying_brilliant();

}  // namespace sunfleck::engine
