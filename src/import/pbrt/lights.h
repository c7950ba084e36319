// LightSource and AreaLightSource statements as our lights.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"
#include "scene/description.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// The types of LightSource, and what each means.
std::span<const WordRow> light_words();

/// Adds the light of a LightSource statement, placed by the current matrix.
/// @throws Error for an unknown type and for parameters that no such light can have.
void add_light(const Statement& statement, Reading& reading);

/// The emission that an AreaLightSource statement gives to the shapes that follow.
/// @throws Error as add_light() does.
AreaEmission area_emission(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
