// Opaque surfaces of glTF: plastic and metal with all that extensions put on them.
//
// Source: glTF 2.0 Specification, appendix B; the KHR_materials extensions clearcoat, specular,
// iridescence and diffuse_transmission. docs/reference/gltf.md tells what is approximated.
#pragma once

#include "import/gltf/pbr.h"
#include "scene/description.h"

#include <cstdint>
#include <optional>

namespace sunfleck::engine {

/// Adds materials of one surface to a scene.
class GltfSurface {
public:
    /// All must outlive this. @param bump_map  of all materials of the surface.
    GltfSurface(SceneDescription& scene, GltfTextures& textures, BumpMap bump_map)
        : scene_(scene), textures_(textures), bump_map_(std::move(bump_map)) {}

    /// Adds a material. @return its number.
    std::uint32_t add(Material material);
    /// Adds a mix, unless one of both has all.
    /// @param first, second  each adds its material and returns the number.
    /// @param amount  of the second.
    template <class First, class Second>
    std::uint32_t add_mix(const First& first, const Second& second, const FloatTexture& amount) {
        if (amount.is_constant() && amount.constant() == 0) return first();
        if (amount.is_constant() && amount.constant() == 1) return second();
        const std::uint32_t one = first();
        return add(MixMaterial{{one, second()}, amount});
    }

    /// Adds what a material is where it lets no light through. @param material  glTF's default
    /// without one.
    std::uint32_t add_opaque(const GltfPbr& pbr, const std::optional<JsonPlace>& material);

private:
    std::uint32_t add_uncoated(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_dielectric(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_plastic(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_metal(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_coated(const GltfPbr& pbr, const JsonPlace& clearcoat);

    SceneDescription& scene_;
    GltfTextures& textures_;
    BumpMap bump_map_;
};

}  // namespace sunfleck::engine
