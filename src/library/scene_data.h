// What a Scene of the interface shares among its copies.
#pragma once

#include "image/exposure.h"
#include "scene/scene.h"
#include "sunfleck/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace sunfleck {

struct Scene::Data {
    engine::Scene scene;
    std::string isa;
    std::vector<std::string> files;
    engine::Camera camera_in_world;
    engine::Exposure exposure;  // of pictures that are saved where the settings have none
};

/// Reads a scene and builds its geometry. @throws Error
Scene built_scene(const SceneOptions& options,
                  const std::function<engine::SceneDescription()>& read,
                  const engine::Exposure& exposure = {});

}  // namespace sunfleck
