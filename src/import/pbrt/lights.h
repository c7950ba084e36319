// Conversion of LightSource and AreaLightSource statements to lights.
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
/// @throws Error  for an unknown type, and for invalid parameters.
void add_light(const Statement& statement, Reading& reading);

/// Returns the emission of an AreaLightSource statement, which note_light() is to complete.
/// @throws Error  as add_light().
AreaEmission area_emission(const Statement& statement, Reading& reading);

/// Adds a statement to the scene's light statements.
/// @return its index in the description: AreaEmission::statement.
std::uint32_t note_light(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
