// The flux that the points of a block take, summed for eight points side by side.
#pragma once

#include "visible_points/lookup.h"

#include <span>

namespace sunfleck::engine {

/// Light that arrives at the eight points of a block.
using BlockLight = std::array<SampledSpectrum, DiscBlock::kWidth>;

/// Adds to light[i], in the order of the list, the flux of every photon of that kind that point i
/// accepts, for the points whose bit is set in `points`.
void add_flux(const SortedPhotons& photons, std::span<const TakenPhoton> taken, PhotonKind kind,
              unsigned points, BlockLight& light);

}  // namespace sunfleck::engine
