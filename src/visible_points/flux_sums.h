// Sums of photon flux per visible point, for the eight points of a block at once.
#pragma once

#include "visible_points/lookup.h"

#include <span>

namespace sunfleck::engine {

/// Flux at the eight points of a block.
using BlockLight = std::array<SampledSpectrum, DiscBlock::kWidth>;

/// Adds the flux of every photon of a kind that point i accepts to light[i], in list order, for the
/// points whose bit is set in `points`.
void add_flux(const SortedPhotons& photons, std::span<const TakenPhoton> taken, PhotonKind kind,
              unsigned points, BlockLight& light);

}  // namespace sunfleck::engine
