// Conversion of a Texture statement; a row for each class of the language. The caller looks up the
// textures that it refers to (textures.h).
#pragma once

#include "import/pbrt/texture_parameters.h"
#include "import/pbrt/vocabulary_row.h"
#include "texture/texture.h"

#include <map>
#include <span>
#include <string_view>

namespace sunfleck::engine {

/// Returns all classes of both kinds.
std::span<const std::string_view> texture_classes();
/// The same with what each means.
std::span<const WordRow> texture_words();

/// A parameter of a class that may be a texture, and its default.
struct TextureOperand {
    std::string_view name;
    float fallback = 0;
    bool is_number = false;  // a float texture also in spectrum textures
};

/// Returns the texture parameters of a class. @param word  one of texture_classes().
std::span<const TextureOperand> texture_operands(std::string_view word);

/// The input textures of a texture, by parameter name.
template <class T>
struct TextureOperands {
    std::map<std::string_view, T> own;  // of the same kind as the texture
    std::map<std::string_view, FloatTexture> numbers;
};

/// @tparam T  FloatTexture or SpectrumTexture.
/// @param operands  all of texture_operands().
/// @throws Error  for invalid parameters, and for a class that exists for the other kind only.
template <class T>
T texture_of(const TextureInput& input, const TextureOperands<T>& operands, ImageTable& images,
             ImportLog& log);

}  // namespace sunfleck::engine
