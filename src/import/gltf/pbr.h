// Metallic-roughness: the parameters of a glTF material, and our textures of them.
//
// Source: glTF 2.0 Specification, section 3.9.2; KHR_materials_anisotropy.
#pragma once

#include "import/gltf/textures.h"
#include "material/material.h"

#include <optional>

namespace sunfleck::engine {

/// The parameters of a surface, with their textures.
struct GltfPbr {
    Vec3d base{1};
    double alpha = 1;
    double metallic = 1;
    double roughness = 1;
    double ior = 1.5;
    double anisotropy = 0;  // strength in [0,1]
    std::optional<GltfTextures::Slot> colour{};
    std::optional<GltfTextures::Slot> opacity{};    // alpha of `colour`, linear; none if it is 1
    std::optional<GltfTextures::Slot> green{};      // roughness
    std::optional<GltfTextures::Slot> blue{};       // metallic
    std::optional<GltfTextures::Slot> direction{};  // of anisotropy: its strength
    GltfVertices vertices{};
};

/// Returns the parameters of a material; glTF's default without one.
GltfPbr pbr_of(const std::optional<JsonPlace>& material, GltfTextures& textures,
               const GltfVertices& vertices);

/// Returns the base colour: of the factor, the texture and the vertices.
SpectrumTexture base_colour(const GltfPbr& pbr);
/// Returns a colour with its texture, if it has one.
SpectrumTexture colour_of(const std::optional<GltfTextures::Slot>& slot, const Vec3d& factor);
/// Returns a factor times its texture, if it has one.
FloatTexture number_of(const std::optional<GltfTextures::Slot>& slot, double factor);
/// Returns alpha: of the factor, the texture and the vertices.
FloatTexture alpha_of(const GltfPbr& pbr);
/// Returns the GGX alphas: the square of the roughness, wider along the tangent by the anisotropy.
Roughness roughness_of(const GltfPbr& pbr);
FloatTexture metallic_of(const GltfPbr& pbr);

/// Returns a coat's facets of one width everywhere: of textures the mean. None if it is smooth.
std::optional<Ggx> mean_facets(const GltfPbr& pbr);
std::optional<Ggx> mean_facets(const std::optional<GltfTextures::Slot>& slot, double roughness);

}  // namespace sunfleck::engine
