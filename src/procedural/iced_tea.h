// The scene iced-tea: a tumbler of tea with ice under a clear sky, and its light on the table.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck {

/// Indices of refraction, the same at all wavelengths: soda-lime glass, water, ice.
inline constexpr double kTumblerIndex = 1.52;
inline constexpr double kTeaIndex = 1.333;
inline constexpr double kIceIndex = 1.31;

/// The scene's file, five meshes and the sky. Centimetres, z up.
std::vector<SceneFile> iced_tea_scene();

}  // namespace sunfleck
