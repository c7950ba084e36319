// Shape statements as our shapes, with the material and emission of the graphics state.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// The types of Shape, and what each means.
std::span<const WordRow> shape_words();

/// Adds the shape to the world, or to the object that is open.
/// @throws Error for an unknown type and for parameters that no such shape can have.
void add_shape(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
