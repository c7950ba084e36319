// Adds a pass to a film, with all its statistics.
#pragma once

#include "film/film.h"
#include "stages/pass_result.h"

namespace sunfleck::engine {

/// Unit of the statistic "visible_fraction_square": squares of 1e-9 keep their digits.
inline constexpr double kSquareUnits = 0x1p32;

/// Where the lights of a pass are in several strata, each has its statistics under
/// "stratum.G.", G from 0; else the one splitting's are under "splitting.".
void add_pass(Film& film, std::uint32_t number, const PassResult& pass);

/// Returns who brought indirect light in the passes of a film: in all of them the same.
IndirectLight indirect_of(const Film& film);

}  // namespace sunfleck::engine
