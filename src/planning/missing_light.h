// Detection of missing light: the part of a picture that lacks light because no photon was found.
//
// In:  scene, settings. Out: a fraction of the picture, by importons from the visible points, which
// search in the reverse direction and hence fail in other places.
#pragma once

#include "scene/scene.h"
#include "stages/settings.h"

namespace sunfleck::engine {

/// Returns the fraction of pixels near which importons find light that photons compute: by rough
/// surfaces, or through glass. Light that arrives by mirrors alone, or through strongly refracting
/// glass, is not found. Zero for other integrators, which have no photons.
/// @param settings  with who brings indirect light: not `automatic`.
double share_lit_by_photons(const Scene& scene, const RenderSettings& settings);

}  // namespace sunfleck::engine
