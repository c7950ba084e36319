// TextureWriter: textures as pbrt-v4 statements, each once, and as parameters that name them.
#pragma once

#include "export/picture_files.h"
#include "export/statement_text.h"
#include "texture/texture.h"

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace sunfleck::engine {

class TextureWriter {
public:
    /// All must outlive this.
    TextureWriter(PictureFiles& pictures, Warnings& warnings, SourceLocation scene)
        : pictures_(pictures), warnings_(warnings), scene_(std::move(scene)) {}

    /// Adds a parameter to a statement that follows text().
    void add(StatementText& statement, std::string_view name, const FloatTexture& texture);
    void add(StatementText& statement, std::string_view name, const SpectrumTexture& texture,
             ColourUse use);

    /// Sets the mapping that meshes to come have in their coordinates: textures with it are written
    /// without a mapping. Null for none.
    void set_mapping_of_meshes(const Mapping* mapping) { of_meshes_ = mapping; }
    bool has_mapping_of_meshes() const { return of_meshes_ != nullptr; }

    /// Returns the statements of all textures so far.
    const std::string& text() const { return text_; }

    void warn(const std::string& text) { warnings_.add(scene_, text); }

private:
    friend struct TextureStatements;

    std::string name_of(const FloatKind& kind);
    std::string name_of(const SpectrumKind& kind, ColourUse use);

    PictureFiles& pictures_;
    Warnings& warnings_;
    SourceLocation scene_;
    std::string text_;
    int count_ = 0;
    const Mapping* of_meshes_ = nullptr;
    std::map<std::pair<const FloatKind*, bool>, std::string> numbers_;
    std::map<std::tuple<const SpectrumKind*, ColourUse, bool>, std::string> spectra_;
};

}  // namespace sunfleck::engine
