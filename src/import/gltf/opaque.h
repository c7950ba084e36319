// Opaque surfaces of glTF: plastic and metal with all that extensions put on them.
//
// Source: glTF 2.0 Specification, appendix B; the KHR_materials extensions clearcoat, specular,
// sheen, iridescence and diffuse_transmission. docs/reference/gltf.md tells what is approximated.
#pragma once

#include "import/gltf/coats.h"
#include "import/gltf/pbr.h"
#include "scene/description.h"

#include <cstdint>
#include <optional>

namespace sunfleck::engine {

/// Adds materials of one surface to a scene.
class GltfSurface {
public:
    /// All must outlive this. @param bump_map  of all materials of the surface.
    GltfSurface(SceneDescription& scene, GltfTextures& textures, GltfCoats& coats, BumpMap bump_map)
        : scene_(scene), textures_(textures), coats_(coats), bump_map_(std::move(bump_map)) {}

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
    /// Adds a material for each step of a roughness, mixed. @param add_one  of the coat's facets.
    template <class AddOne>
    std::uint32_t add_steps(const RoughnessSteps& steps, double strength, const AddOne& add_one) {
        std::uint32_t made = add_one(facets_of(steps.roughness.front(), strength));
        for (std::size_t i = 0; i < steps.amounts.size(); ++i) {
            const std::uint32_t next = add_one(facets_of(steps.roughness[i + 1], strength));
            made = add(MixMaterial{{made, next}, steps.amounts[i]});
        }
        return made;
    }
    std::uint32_t add_uncoated(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_unsheened(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_dielectric(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_plastic(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_metal(const GltfPbr& pbr, const std::optional<JsonPlace>& material);
    std::uint32_t add_coated(const GltfPbr& pbr, const JsonPlace& material,
                             const JsonPlace& clearcoat);

    SceneDescription& scene_;
    GltfTextures& textures_;
    GltfCoats& coats_;
    BumpMap bump_map_;
};

}  // namespace sunfleck::engine
