// Textures by name, and parameters that may be textures.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/spectra.h"
#include "import/pbrt/texture_kinds.h"
#include "texture/texture.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace sunfleck::engine {

class TextureTable {
public:
    /// All three must outlive this.
    TextureTable(SpectrumReader& spectra, ImageTable& images, ImportLog& log)
        : spectra_(spectra), images_(images), log_(log) {}

    /// @param kind  "float" or "spectrum". @param statement  its type is the class.
    /// @param to_world  the matrix at the statement: the texture's frame.
    /// @throws Error for an unknown kind or class, or a name given before.
    void add(const std::string& kind, const std::string& name, Statement statement,
             const Matrix& to_world);

    /// A number or a float texture, if there is a parameter of that name. Textures are made when
    /// they are first asked for.
    /// @throws Error for the name of no texture, and for parameters of it that cannot be used.
    std::optional<FloatTexture> find_number(const Statement& statement, std::string_view name);

    /// A spectrum or a spectrum texture, likewise.
    std::optional<SpectrumTexture> find_spectrum(const Statement& statement, std::string_view name,
                                                 SpectrumUse use);

private:
    /// Of the tree of textures below one, that one included.
    struct Tree {
        int depth = 0;
        double lookups = 0;  // as often as the tree has them, where parts are shared

        void add(const Tree& part) {
            depth = std::max(depth, part.depth);
            lookups += part.lookups;
        }
    };

    struct Entry {
        Statement statement;
        Matrix to_world;
        std::size_t order = 0;
        Tree tree;  // once it is made
        std::optional<FloatTexture> number;
        std::map<SpectrumUse, SpectrumTexture> spectra;
    };

    Entry& entry_of(const std::string& kind, const Parameter& parameter);
    FloatTexture number(const Parameter& parameter);
    SpectrumTexture spectrum(const Parameter& parameter, SpectrumUse use);
    template <class T>
    T make(Entry& entry, SpectrumUse use);
    template <class T>
    TextureParts<T> parts_of(const Statement& statement, SpectrumUse use);

    SpectrumReader& spectra_;
    ImageTable& images_;
    ImportLog& log_;
    std::map<std::pair<std::string, std::string>, Entry> textures_;  // by kind and name
    std::size_t limit_ = ~std::size_t{0};  // textures see only those that were made before
    Tree below_;                           // of what is below the texture that is being made
    int open_ = 0;                         // textures that are being made
};

}  // namespace sunfleck::engine
