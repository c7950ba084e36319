// The scene two-windows: patches of sun far apart, each from a window of its own.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Half the width and depth of the ground around the hall, m: it sets how rarely a photon path of
/// the sun is visible.
inline constexpr double kGroundHalfWidth = 14;

/// Metres, z up.
std::vector<SceneFile> two_windows_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
