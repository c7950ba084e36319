// A pass added to a film, with all that it counted.
#pragma once

#include "film/film.h"
#include "stages/pass_result.h"

namespace sunfleck::engine {

/// The statistic "visible_fraction_square" is in units of 1 / this: squares of 1e-9 have digits.
inline constexpr double kSquareUnits = 0x1p32;

/// Where the lights of a pass are in several strata, each has its statistics under
/// "stratum.G.", G from 0; else the one splitting's are under "splitting.".
void add_pass(Film& film, std::uint32_t number, const PassResult& pass);

}  // namespace sunfleck::engine
