// Adds lights, materials and media to a scene's description, as importers do one by one.
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

/// Adds a material. @return its index.
inline std::uint32_t add_material(SceneDescription& scene, Material material,
                                  const BumpMap& bump_map = {}) {
    scene.materials.push_back(std::move(material));
    scene.bump_maps.resize(scene.materials.size());
    scene.bump_maps.back() = bump_map;
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

/// Names a material, for mattes.
inline void name_material(SceneDescription& scene, std::uint32_t material, std::string name) {
    if (scene.material_names.size() <= material)
        scene.material_names.resize(std::size_t{material} + 1);
    scene.material_names[material] = std::move(name);
}

/// Adds a medium that absorbs alone. @param absorption  per metre. @return its number.
inline MediumNumber add_medium(SceneDescription& scene, const Spectrum& absorption) {
    scene.media.all.push_back({absorption, Spectrum(), 0});
    return static_cast<MediumNumber>(scene.media.all.size() - 1);
}

}  // namespace sunfleck::engine
