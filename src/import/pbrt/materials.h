// Conversion of one material statement; a row for each word of the language.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"
#include "material/bump_map.h"
#include "material/material.h"

#include <span>

namespace sunfleck::engine {

/// Returns all words, with "" (for an interface).
std::span<const std::string_view> material_types();
/// The same with what each means.
std::span<const WordRow> material_words();

/// Converts a statement whose type is one of material_types(). Approximations give a warning. A mix
/// has only its amount set: its "materials" are names, which scene_materials.h looks up.
Material material_of(const Statement& statement, Assets& assets);

/// Converts "displacement" or "normalmap"; if both are given, the normal map wins, as in pbrt-v4.
BumpMap bump_map_of(const Statement& statement, Assets& assets);

}  // namespace sunfleck::engine
