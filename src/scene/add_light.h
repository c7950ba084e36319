// Adds a light to a scene's description.
#pragma once

#include "scene/description.h"

#include <utility>

namespace sunfleck::engine {

/// Adds a light with a statement of its own.
inline void add_light(SceneDescription& scene, LightStatement statement, Light light) {
    scene.stated_in.resize(scene.lights.size(), kNone);
    scene.stated_in.push_back(static_cast<std::uint32_t>(scene.light_statements.size()));
    scene.light_statements.push_back(std::move(statement));
    scene.lights.push_back(std::move(light));
}

}  // namespace sunfleck::engine
