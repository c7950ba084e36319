// A Texture statement as one of our textures; a row for each class of the language.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/spectra.h"
#include "texture/texture.h"

#include <span>

namespace sunfleck {

/// All classes, of either kind.
std::span<const std::string_view> texture_classes();

/// @tparam T  FloatTexture or SpectrumTexture. @param to_world  the texture's frame.
/// @param use  what a spectrum is for. @throws Error for parameters that cannot be used, and for a
/// class that has only the other kind.
template <class T>
T texture_of(const Statement& statement, const Matrix& to_world, SpectrumUse use, Reading& reading);

}  // namespace sunfleck
