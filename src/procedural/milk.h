// The scene milk: a glass of milk, and a glass of water into which a drop of milk sinks.
#pragma once

#include "procedural/filled_glass.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

inline constexpr std::size_t kMilkGlassSegments = 128;

/// Returns the curves that both glasses share. Unit: centimetres; the axis is x = y = 0.
GlassCurves milk_glass_curves();

std::vector<SceneFile> milk_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
