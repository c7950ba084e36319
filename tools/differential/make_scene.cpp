// Puts the parts of a scene together.
#include "differential/make_scene.h"

#include "differential/scene_parts.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine::differential {
namespace {

template <std::size_t N>
bool is_any(std::string_view value, const std::array<std::string_view, N>& values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

/// Whether a path may end at a light that it cannot hit.
bool has_light_without_extent(const Ingredients& scene) {
    return scene["second light"] == "point" ||
           is_any(scene["light"], std::array<std::string_view, 5>{"point", "spot", "distant",
                                                                  "goniometric", "projection"});
}

bool has_smooth_surface(const Ingredients& scene) {
    const bool is_smooth = scene["roughness"] == "smooth" || scene["roughness"] == "slight";
    return scene["material"] == "thindielectric" || scene["material"] == "mirror mix" ||
           scene["floor"] == "mirror mix" || scene["beside"] == "glass ball" ||
           scene["beside"] == "mirror ball" || is_smooth;
}

}  // namespace

SceneText make_scene(const FeatureTable& table, const Choice& choice, std::uint64_t seed,
                     std::uint32_t number) {
    Ingredients scene(table, choice, RandomStream(seed, Purpose::test, 1, number));
    SceneText text{view_block(scene), {}};
    Block state{false, {}};
    // On both sides: where an open shape, such as a lamp of two sides, parts it from another
    // medium, no estimator is right.
    if (scene["haze"] == "thin")
        state.statements.push_back({R"(MediumInterface "haze" "haze")", {}});
    if (const std::string_view space = scene["colour space"]; space != "none")
        state.statements.push_back({"ColorSpace \"" + std::string(space) + '"', {}});
    if (!state.statements.empty()) text.world.push_back(state);
    for (auto* part : {light_blocks, surroundings, object_blocks})
        for (Block& block : part(scene)) text.world.push_back(std::move(block));
    return text;
}

bool is_found_by_path(const FeatureTable& table, const Choice& choice) {
    const Ingredients scene(table, choice, RandomStream(0, Purpose::test, 1, 0));
    return !(has_light_without_extent(scene) && has_smooth_surface(scene));
}

}  // namespace sunfleck::engine::differential
