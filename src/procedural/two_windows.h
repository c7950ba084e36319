// The scene two-windows: two patches of sun far apart, one from each window.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Half the width and depth of the ground around the hall in m. It sets the visible fraction of the
/// sun's photon paths.
inline constexpr double kGroundHalfWidth = 14;

/// Unit: metres; z is up.
std::vector<SceneFile> two_windows_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
