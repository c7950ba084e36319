// MaterialWriter: materials as named ones of pbrt-v4, each once.
#pragma once

#include "export/textures.h"
#include "material/bump_map.h"
#include "material/material.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sunfleck::engine {

class MaterialWriter {
public:
    /// All must outlive this. @param bump_maps  may be shorter than the materials.
    MaterialWriter(const std::vector<Material>& materials, const std::vector<BumpMap>& bump_maps,
                   PictureFiles& pictures, TextureWriter& textures)
        : materials_(materials), bump_maps_(bump_maps), pictures_(pictures), textures_(textures) {}

    /// Returns the statement that makes shapes to come of that material.
    std::string use(std::uint32_t number);

    /// Returns the statements of all materials so far. They follow those of the textures.
    const std::string& text() const { return text_; }

private:
    friend struct MaterialStatements;

    std::string name_of(std::uint32_t number);
    void add_bump_map(StatementText& statement, const BumpMap& bump_map);

    const std::vector<Material>& materials_;
    const std::vector<BumpMap>& bump_maps_;
    PictureFiles& pictures_;
    TextureWriter& textures_;
    std::string text_;
    /// By number, and whether meshes have the mapping of its textures.
    std::map<std::pair<std::uint32_t, bool>, std::string> names_;
    std::vector<SpectrumTexture> made_;  // kept, so that each has an address of its own
};

}  // namespace sunfleck::engine
