// Film, PixelFilter, Sampler and Integrator statements: picture and hints.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// The types of PixelFilter, and what each means.
std::span<const WordRow> filter_words();

/// Reads the last statement of each kind into the scene; pbrt-v4's defaults without one.
/// @throws Error for a picture of absurd size and for values out of range.
void finish_film(Reading& reading);
void finish_filter(Reading& reading);
void finish_guide_samples(Reading& reading);

}  // namespace sunfleck::engine
