// Which part of a picture lacks light, where passes have found no photon that brings any.
//
// In:  scene, settings. Out: a share of the picture, from walks that look for light from what the
// camera sees: the other way round than photons go, so that they fail in other places.
#pragma once

#include "scene/scene.h"
#include "stages/settings.h"

namespace sunfleck::engine {

/// Share of the pixels by whose side walks meet light that photons are to bring there: by way of
/// rough surfaces, or through glass. Light that reaches the view by mirrors alone, or through glass
/// that bends it far, is not met. Zero with other integrators, which have no photons.
double share_lit_by_photons(const Scene& scene, const RenderSettings& settings);

}  // namespace sunfleck::engine
