// Conversion of the Film, PixelFilter, Sampler and Integrator statements.
#pragma once

#include "import/pbrt/import_log.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// Returns the types of PixelFilter, and what each means.
std::span<const WordRow> filter_words();

/// Returns the film of a Film statement, as if it were exposed for one second at ISO 100.
/// @throws Error  for an unknown type, and for values out of range.
FilmDescription film_of(const Statement& film, ImportLog& log);
/// Returns the filter of a PixelFilter statement. @throws Error  as film_of().
FilterSettings filter_of(const Statement& filter);
/// Returns the exposure time of a Camera statement, in seconds.
/// @throws Error  if the shutter closes when it opens.
double exposure_time_of(const Statement& camera, ImportLog& log);

/// Converts the last statement of each kind; pbrt-v4's defaults without one.
/// @throws Error  for values out of range.
void finish_film(Reading& reading);
void finish_filter(Reading& reading);
void finish_hints(Reading& reading);

}  // namespace sunfleck::engine
