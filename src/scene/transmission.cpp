// By the kind of material; of a mix, by its parts.
#include "scene/transmission.h"

namespace sunfleck::engine {

bool lets_light_through(const std::vector<Material>& materials, std::uint32_t material) {
    const Material& here = materials[material];
    if (const auto* mix = std::get_if<MixMaterial>(&here))
        return lets_light_through(materials, mix->parts[0]) ||
               lets_light_through(materials, mix->parts[1]);
    return std::holds_alternative<InterfaceMaterial>(here) ||
           std::holds_alternative<DielectricMaterial>(here) ||
           std::holds_alternative<ThinDielectricMaterial>(here) ||
           std::holds_alternative<DiffuseTransmissionMaterial>(here);
}

}  // namespace sunfleck::engine
