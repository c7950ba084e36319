// Parameters that several classes of textures have in common: mapping, octaves, image.
#pragma once

#include "import/pbrt/images.h"
#include "import/pbrt/import_log.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/spectra.h"
#include "texture/kinds.h"

#include <span>
#include <string_view>

namespace sunfleck::engine {

/// What a Texture statement says, but for the textures that it is made of.
struct TextureInput {
    const Statement& statement;
    const Matrix& to_world;  // the texture's frame
    SpectrumUse use;         // what a spectrum is for

    Affine to_texture() const { return Placement(to_world).to_object; }
    float real(std::string_view name, double fallback) const {
        return static_cast<float>(statement.real(name, fallback));
    }
    Vec3 vector(std::string_view name, const Vec3& fallback) const;
    /// The index of a word in a list; 0 where there is no parameter of that name.
    std::size_t choice(std::string_view name, std::span<const std::string_view> words) const;
};

Mapping mapping_of(const TextureInput& input);

Octaves octaves_of(const TextureInput& input);

/// The image enters the table. The log is told of filters that are not simulated.
ImageKind image_of(const TextureInput& input, ImageTable& images, ImportLog& log);

}  // namespace sunfleck::engine
