// The Bsdf at a vertex of a reference path, with its effect on the path's wavelengths.
#pragma once

#include "scene/pass_scene.h"

namespace sunfleck::engine {

/// Returns the Bsdf at a hit for the path: at a dispersive surface that is not specular, the path
/// terminates its secondary wavelengths; a path of one wavelength gets the Bsdf of that wavelength.
/// @param hit  a bump or normal map changes its shading normal and tangent.
inline Bsdf vertex_bsdf(const PassScene& scene, Hit& hit, SampledSpectrum& throughput,
                        HeroWavelength& hero) {
    std::optional<Bsdf> room;
    const Bsdf& bsdf = scene.bsdf_at(hit, room);
    if (!is_dispersive(bsdf)) return bsdf;
    if (scattering(bsdf) != Scattering::specular) terminate_secondary(throughput, hero);
    return hero.single ? at_wavelength(bsdf, hero.chosen) : bsdf;
}

}  // namespace sunfleck::engine
