// Lights with the intensities of a luminaire.
#pragma once

#include "import/ies/photometry.h"
#include "light/image_point_lights.h"

namespace sunfleck::engine {

/// Returns the intensities as a map of directions, in candela.
std::shared_ptr<const LightImage> intensity_map(const Photometry& photometry);

/// Returns a spectrum of the same colour for intensities in candela: 683 lm are 1 W.
Spectrum per_candela(const Spectrum& colour);

}  // namespace sunfleck::engine
