// TextureTable: textures by name, and parameters that may be textures.
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

    /// Makes a copy that reads by other tables.
    TextureTable(const TextureTable& other, SpectrumReader& spectra, ImageTable& images,
                 ImportLog& log)
        : spectra_(spectra),
          images_(images),
          log_(log),
          textures_(other.textures_),
          at_(other.at_) {}

    /// @param kind  "float" or "spectrum".
    /// @param statement  its type is the class.
    /// @param to_world  matrix at the statement: the texture's frame.
    /// @throws Error  for an unknown kind or class, or a repeated name.
    void add(const std::string& kind, const std::string& name, Statement statement,
             const Matrix& to_world);

    /// Returns a number or float texture, if the parameter is given. Textures are converted at
    /// their first use.
    /// @throws Error  for an unknown name, and for invalid parameters of the texture.
    std::optional<FloatTexture> find_number(const Statement& statement, std::string_view name);

    /// Returns a spectrum or spectrum texture, if the parameter is given.
    std::optional<SpectrumTexture> find_spectrum(const Statement& statement, std::string_view name,
                                                 SpectrumUse use);

private:
    /// Size of the tree of textures below a texture, itself included.
    struct Tree {
        int depth = 0;
        double lookups = 0;  // counts shared textures repeatedly

        void add(const Tree& part) {
            depth = std::max(depth, part.depth);
            lookups += part.lookups;
        }
    };

    /// Where conversion is in the trees of textures.
    struct Position {
        std::size_t limit = ~std::size_t{0};  // textures can only use those that were made before
        Tree below;                           // below the texture that is being converted
        int open = 0;                         // textures that are being converted
    };

    struct Entry {
        Statement statement;
        Matrix to_world;
        std::size_t order = 0;
        Tree tree;  // valid after conversion
        std::optional<FloatTexture> number;
        std::map<SpectrumUse, SpectrumTexture> spectra;
    };

    Entry& entry_of(const std::string& kind, const Parameter& parameter);
    FloatTexture number(const Parameter& parameter);
    SpectrumTexture spectrum(const Parameter& parameter, SpectrumUse use);
    template <class T>
    T make(Entry& entry, SpectrumUse use);
    template <class T>
    TextureOperands<T> operands_of(const Statement& statement, SpectrumUse use);

    SpectrumReader& spectra_;
    ImageTable& images_;
    ImportLog& log_;
    std::map<std::pair<std::string, std::string>, Entry> textures_;  // by kind and name
    Position at_;
};

}  // namespace sunfleck::engine
