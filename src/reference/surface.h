// What scatters at a vertex of a reference path, and what that does to the path's wavelengths.
#pragma once

#include "scene/pass_scene.h"

namespace sunfleck::engine {

/// The Bsdf at a hit, as the path sees it: where wavelengths part and the surface is not smooth,
/// the path keeps its chosen wavelength from here on; a path of one wavelength sees that
/// wavelength's Bsdf.
/// @param hit  its shading normal and tangent are bent where the material has a relief.
inline Bsdf met_bsdf(const PassScene& scene, Hit& hit, SampledSpectrum& throughput,
                     HeroWavelength& hero) {
    std::optional<Bsdf> room;
    const Bsdf& bsdf = scene.bsdf_at(hit, room);
    if (!is_dispersive(bsdf)) return bsdf;
    if (scattering(bsdf) != Scattering::specular) terminate_secondary(throughput, hero);
    return hero.single ? at_wavelength(bsdf, hero.chosen) : bsdf;
}

}  // namespace sunfleck::engine
