// Where a medium glows, as a density from which points are drawn.
#pragma once

#include "medium/glow.h"

namespace sunfleck::engine {

/// Returns a density on the lattice of a medium's density: the luminance of rho E around its
/// points, plus a tenth of its mean in proportion to rho, so that no light is missed between them.
/// @param glow  one that varies.
DensityGrid glow_power(const DensityGrid& density, const Glow& glow);

}  // namespace sunfleck::engine
