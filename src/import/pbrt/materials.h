// One material of a scene file as one of ours; a row for each word of the language.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"
#include "material/bump_map.h"
#include "material/material.h"

#include <span>

namespace sunfleck::engine {

/// The words that there are, "" (for an interface) among them.
std::span<const std::string_view> material_types();
/// The same with what each means.
std::span<const WordRow> material_words();

/// The material of a statement whose type is one of material_types(). What is approximated is
/// said in a warning. A mix comes with its amount alone: its "materials" are names, which
/// scene_materials.h looks up.
Material material_of(const Statement& statement, Assets& assets);

/// "displacement" or "normalmap"; the map wins where there are both, as in pbrt-v4.
Relief relief_of(const Statement& statement, Assets& assets);

}  // namespace sunfleck::engine
