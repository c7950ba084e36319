// What media emit: "Le", "Lescale" and temperatures.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "medium/glow.h"

namespace sunfleck::engine {

/// Returns a radiance times "Lescale", one number.
/// @throws Error  for a negative number, and for a product that is no finite float.
Spectrum times_lescale(const Statement& medium, const Spectrum& radiance);

/// Returns a glow that varies with its power; null if nothing glows where the density is.
std::shared_ptr<const Glow> finished_glow(Glow glow, const DensityGrid& density);

/// Returns what a MakeNamedMedium emits; null if that is nothing.
/// @param density  of the medium, if it varies.
/// @param to_world  the matrix of the statement.
/// @throws Error  for values that cannot be, and for a file that cannot be used.
std::shared_ptr<const Glow> glow_of(const Statement& medium,
                                    const std::shared_ptr<const Density>& density,
                                    const Matrix& to_world, Assets& assets);

}  // namespace sunfleck::engine
