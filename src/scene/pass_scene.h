// The scene at the wavelengths of one pass: every curve evaluated once.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <vector>

namespace sunfleck {

struct PassScene {
    const Scene& scene;
    Wavelengths wavelengths;
    std::vector<std::optional<Bsdf>> bsdfs;  // by material; nothing for an interface
    std::vector<Spectrum> emission;          // by light: its curve
    Spectrum white;                          // D65 of luminance one

    PassScene(const Scene& of, PassId pass);

    const Bsdf& bsdf_of(const Hit& hit) const { return *bsdfs[scene.material_of(hit)]; }
};

}  // namespace sunfleck
