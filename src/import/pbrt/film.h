// Conversion of the Film, PixelFilter, Sampler and Integrator statements.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// Returns the types of PixelFilter, and what each means.
std::span<const WordRow> filter_words();

/// Converts the last statement of each kind; pbrt-v4's defaults without one.
/// @throws Error  for values out of range.
void finish_film(Reading& reading);
void finish_filter(Reading& reading);
void finish_hints(Reading& reading);

}  // namespace sunfleck::engine
