// Materials by name: glasses, metals, plastics and matt ones, for parts whose files say none.
//
// A name is written [FAMILY:]NAME[:ROUGHNESS][:COLOUR], such as bk7, glass:bk7, gold:0.2 or
// plastic:red:0.4. docs/reference/materials.md is the page for users.
#pragma once

#include "material/substances.h"
#include "sunfleck/error.h"

#include <span>
#include <string_view>

namespace sunfleck::engine {

/// Returns all names, family by family. The name of a family alone means its first.
std::span<const MaterialName> material_names();

/// Returns the words for colours of plastics and matt materials; #rrggbb is the other form.
std::span<const std::string_view> colour_names();

/// @param text  as above; letters of any case, "_" as "-".
/// @param where  the flag or setting, for errors.
/// @throws Error  for an unknown name, with the nearest ones, and for what the material has not.
NamedMaterial named_material(std::string_view text, const SourceLocation& where);

}  // namespace sunfleck::engine
