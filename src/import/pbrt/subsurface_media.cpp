// One medium for each material.
#include "import/pbrt/subsurface_media.h"

#include "import/pbrt/subsurface.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns the medium of a material, or of the first part of a mix that has one; 0 for none.
MediumNumber medium_of(const std::vector<Material>& materials,
                       const std::vector<MediumNumber>& media, std::uint32_t material) {
    const auto* mix = std::get_if<MixMaterial>(&materials[material]);
    if (mix == nullptr) return media[material];
    const MediumNumber first = medium_of(materials, media, mix->components[0]);
    return first != 0 ? first : medium_of(materials, media, mix->components[1]);
}

}  // namespace

void fill_subsurface(const MaterialTable& table, Assets& assets, SceneDescription& scene) {
    if (assets.subsurface != SubsurfaceRule::walked) return;
    std::vector<MediumNumber> media(scene.materials.size(), 0);
    for (std::size_t i = 0; i < table.slots().size(); ++i) {
        const MaterialTable::Slot& slot = table.slots()[i];
        if (!slot.statement && !table.is_made(slot.name)) continue;
        const Statement& statement =
            slot.statement ? *slot.statement : table.named(slot.name, slot.from);
        if (statement.type != "subsurface") continue;
        media[i] = static_cast<MediumNumber>(scene.media.all.size());
        scene.media.all.push_back(medium_below(statement, assets));
    }
    const auto fill = [&](std::vector<ShapeDescription>& shapes) {
        for (ShapeDescription& shape : shapes)
            if (const MediumNumber below = medium_of(scene.materials, media, shape.material))
                shape.media.inside = below;
    };
    fill(scene.shapes);
    for (auto& object : scene.objects) fill(object);
}

}  // namespace sunfleck::engine
