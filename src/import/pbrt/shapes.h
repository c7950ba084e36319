// Conversion of Shape statements, with material and emission of the graphics state.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"
#include "scene/description.h"

#include <optional>
#include <span>

namespace sunfleck::engine {

struct Reading;

/// Returns the types of Shape, and what each means.
std::span<const WordRow> shape_words();

/// Returns the shape of a Shape statement, without material and media; nothing if it is invisible
/// and dark. It changes nothing of the reading but its log.
/// @throws Error  for an unknown type, and for invalid parameters.
std::optional<ShapeDescription> shape_of(const Statement& statement, Reading& reading);

/// Adds a shape with the material and media of the graphics state to the world, or to the open
/// object.
void place_shape(ShapeDescription shape, Reading& reading);

/// Adds the shape of a statement.
/// @throws Error  for an unknown type, and for invalid parameters.
void add_shape(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
