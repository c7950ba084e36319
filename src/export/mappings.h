// Texture coordinates as parameters of pbrt-v4's textures.
#pragma once

#include "export/statement_text.h"
#include "texture/mapping.h"

#include <optional>
#include <string>

namespace sunfleck::engine {

/// A mapping as it is written.
struct MappingText {
    Mapping mapping = UvMapping{};  // what is written: u and v scaled and shifted, or in space
    std::optional<Matrix> frame{};  // of the texture, to the world
    std::string lost{};             // what pbrt-v4 cannot say and was left out; or empty
};

MappingText written_mapping(const Mapping& mapping);
MappingText written_mapping(const PointMapping& mapping);

/// Adds what differs from pbrt-v4's defaults. @param mapping  that of a MappingText.
void add_mapping(StatementText& statement, const Mapping& mapping);

}  // namespace sunfleck::engine
