// A Texture statement as one of our textures; a row for each class of the language. The textures
// that it is made of are looked up by the caller, who knows those of the scene (textures.h).
#pragma once

#include "import/pbrt/texture_parameters.h"
#include "import/pbrt/vocabulary_row.h"
#include "texture/texture.h"

#include <map>
#include <span>
#include <string_view>

namespace sunfleck::engine {

/// All classes, of either kind.
std::span<const std::string_view> texture_classes();
/// The same with what each means.
std::span<const WordRow> texture_words();

/// A parameter of a class that may be a texture, and its value where it is not given.
struct TexturePart {
    std::string_view name;
    float fallback = 0;
    bool is_number = false;  // a float texture in textures of either kind
};

/// The parts of a class. @param word  one of texture_classes().
std::span<const TexturePart> texture_parts(std::string_view word);

/// The parts of one texture, by the names of their parameters.
template <class T>
struct TextureParts {
    std::map<std::string_view, T> own;  // of the kind of the texture itself
    std::map<std::string_view, FloatTexture> numbers;
};

/// @tparam T  FloatTexture or SpectrumTexture. @param parts  all of texture_parts().
/// @throws Error for parameters that cannot be used, and for a class that has only the other kind.
template <class T>
T texture_of(const TextureInput& input, const TextureParts<T>& parts, ImageTable& images,
             ImportLog& log);

}  // namespace sunfleck::engine
