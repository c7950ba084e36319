// The scene smoke: smoke that rises from a bowl through a narrow beam of light.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

std::vector<SceneFile> smoke_scene(const ProceduralScene& scene);

}  // namespace sunfleck::engine
