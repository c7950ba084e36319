// Sheen (KHR_materials_sheen) as a matt layer of the same mean albedo.
//
// No lobe here is brightest at grazing angles. So sheen takes a share of the surface: as much as
// the light that it reflects, averaged over all directions; the base has the rest. Energy is
// conserved, colour and mean brightness are right, the bright rim is missing. Source:
// KHR_materials_sheen; Conty Estevez and Kulla, Production Friendly Microfacet Sheen BRDF (2017).
#pragma once

#include "import/gltf/pbr.h"

#include <optional>

namespace sunfleck::engine {

/// Returns the albedo of white sheen, averaged over diffuse light. @param roughness  in [0,1].
double mean_sheen_albedo(double roughness);

struct SheenLayer {
    FloatTexture amount;     // share of the surface, in [0,1]
    SpectrumTexture colour;  // of a diffuse surface
};

/// Returns the layer that an extension asks for; nothing if it is black.
std::optional<SheenLayer> sheen_of(const JsonPlace& extension, GltfTextures& textures,
                                   const GltfVertices& vertices);

}  // namespace sunfleck::engine
